// Compares finished pictures: one with a still, or two stills, as finish.comp compares two looks.
// About a still of other proportions is the grey that surrounds pictures; nothing differs there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/tile.glsl"
#include "rows/compares.glsl"
layout(constant_id = 0) const int compare = 0;
layout(constant_id = 1) const bool has_marks = true;
layout(constant_id = 2) const bool is_difference = false;
layout(constant_id = 3) const bool rounds = false; // the target has 8 bits
layout(binding = 0) uniform sampler2D side_a;
layout(binding = 1) uniform sampler2D side_b;
layout(binding = 2) writeonly uniform image2D target;
layout(binding = 3) buffer Figures {
    uint largest; // bits of the largest difference
    uint bins[];  // counts of differences; the first is left out
} figures_out;
layout(push_constant) uniform Push {
    vec4 wipe;              // common/wipe.glsl
    ivec4 extent_a, extent_b; // corner and size of what each side shows
    ivec2 size;
    float heat_scale;
    float surround; // a code
} push;

void count_difference(float difference) {
    uint bin = min(uint(difference * difference_bins_per_unit), difference_bins - 1u);
    if (bin > 0u) {
        atomicAdd(figures_out.bins[bin], 1u);
    }
    if (floatBitsToUint(difference) > figures_out.largest) {
        atomicMax(figures_out.largest, floatBitsToUint(difference));
    }
}

bool is_in(ivec2 at, ivec4 extent) {
    return all(greaterThanEqual(at, extent.xy)) && all(lessThan(at, extent.xy + extent.zw));
}

void main() {
    bool is_box = compare == compare_box;
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (any(greaterThanEqual(at, push.size))) {
            continue;
        }
        bool has_a = is_in(at, push.extent_a), has_b = is_in(at, push.extent_b);
        vec3 surround = vec3(push.surround);
        Sides sides = Sides(has_a ? texelFetch(side_a, at, 0).rgb : surround,
                            has_b ? texelFetch(side_b, at, 0).rgb : surround);
        if (is_difference && !(has_a && has_b)) {
            sides.a = sides.b = surround;
        }
        show(compare, target, at, push.size, sides,
             Shown(is_before_wipe(is_box, at, push.wipe),
                   on_wipe(is_box, at, push.size, push.wipe), has_marks, push.heat_scale, rounds));
    }
}
