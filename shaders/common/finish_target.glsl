// The picture that finish.comp and finish_shared.comp make, and what they count on the way.
#include "common/finish.glsl"
#include "rows/compares.glsl"

// Whoever includes this has the looks of both sides.
vec3 graded_a(Stages texel);
vec3 graded_b(Stages texel);

layout(constant_id = 10) const bool rounds = false; // the target has 8 bits
layout(binding = 13) writeonly uniform image2D target;
layout(binding = 14) buffer Figures {
    uint largest; // bits of the largest difference
    uint bins[];  // counts of differences; the first is left out
} figures_out;

void count_difference(float difference) {
    uint bin = min(uint(difference * difference_bins_per_unit), difference_bins - 1u);
    if (bin > 0u) {
        atomicAdd(figures_out.bins[bin], 1u);
    }
    if (floatBitsToUint(difference) > figures_out.largest) {
        atomicMax(figures_out.largest, floatBitsToUint(difference));
    }
}

// Each look stands here once, for drivers take functions in wherever they are called before they
// learn which rows are chosen.
void store_texel(ivec2 at, ivec2 size, Stages texel) {
    Sides sides = Sides(vec3(0.0), vec3(0.0));
    bool is_box = compare == compare_box;
    bool is_before = is_before_wipe(is_box, at, push.wipe);
    if (needs_a(compare, is_before)) {
        sides.a = graded_a(texel);
    }
    if (needs_b(compare, is_before)) {
        sides.b = graded_b(texel);
    }
    show(compare, target, at, size, sides,
         Shown(is_before, on_wipe(is_box, at, size, push.wipe), has_marks, push.heat_scale, rounds));
}
