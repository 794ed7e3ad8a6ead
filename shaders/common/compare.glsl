// How two looks are shown together: the functions that rows of preview/finish/compare.h name, each
// for one texel `at` of a picture of that size. The build writes the choice among the rows
// (rows/compares.glsl).
#include "common/difference.glsl"
#include "common/heat_map.glsl"
#include "common/nearest_code.glsl"
#include "common/sanitise.glsl"
#include "common/wipe.glsl"

struct Shown {
    bool is_before; // on side A of the line, or in the box
    bool is_border;
    bool has_marks; // the border, the heat map's scale
    float heat_scale; // dE2000
    bool rounds;      // the target has 8 bits
};

/// A texel as both sides' looks give it; a side that is not shown there is black.
struct Sides {
    vec3 a, b;
};

// Whoever includes this counts differences.
void count_difference(float difference);

void store(writeonly image2D target, ivec2 at, vec3 color, Shown how) {
    imageStore(target, at, vec4(how.rounds ? nearest_code(color) : color, 1.0));
}

void show_a(writeonly image2D target, ivec2 at, ivec2 size, Sides sides, Shown how) {
    store(target, at, sides.a, how);
}

void show_b(writeonly image2D target, ivec2 at, ivec2 size, Sides sides, Shown how) {
    store(target, at, sides.b, how);
}

void show_split(writeonly image2D target, ivec2 at, ivec2 size, Sides sides, Shown how) {
    vec3 side = how.is_before ? sides.a : sides.b;
    store(target, at, how.has_marks && how.is_border ? vec3(1.0) : side, how);
}

/// The target is twice as wide.
void show_side(writeonly image2D target, ivec2 at, ivec2 size, Sides sides, Shown how) {
    store(target, at, sides.a, how);
    store(target, at + ivec2(size.x, 0), sides.b, how);
}

void show_difference(writeonly image2D target, ivec2 at, ivec2 size, Sides sides, Shown how) {
    float difference = delta_e_2000(saturate(sides.a), saturate(sides.b));
    count_difference(difference);
    vec3 color = heat(difference / how.heat_scale);
    store(target, at, how.has_marks ? with_scale(color, at, size, how.heat_scale) : color, how);
}
