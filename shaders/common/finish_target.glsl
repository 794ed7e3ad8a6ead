// The picture that finish.comp and finish_shared.comp make of common/finish.glsl's colours and of
// graded_a() and graded_b(): one look, or the comparison of both.
#include "common/difference.glsl"
#include "common/split_line.glsl"

const int compare_a = 0;
const int compare_b = 1;
const int compare_split = 2;
const int compare_side = 3;
const int compare_difference = 4;

layout(binding = 15) writeonly uniform image2D target;
layout(binding = 16) buffer Figures {
    uint largest; // bits of the largest difference
    uint bins[];  // counts of differences, figure_bins of them; the first is left out
} figures_out;

const uint figure_bins = 4096;
const float bins_per_unit = 40.0;

// Shows the looks of the display-encoded colour `c`.
void store_texel(ivec2 at, ivec2 size, vec3 c) {
    if (compare == compare_a) {
        imageStore(target, at, vec4(graded_a(c), 1.0));
    } else if (compare == compare_b) {
        imageStore(target, at, vec4(graded_b(c), 1.0));
    } else if (compare == compare_split) {
        vec3 side = float(at.x) + 0.5 < push.split * float(size.x) ? graded_a(c) : graded_b(c);
        imageStore(target, at, vec4(has_line && on_line(at.x, size, push.split) ? vec3(1.0) : side, 1.0));
    } else if (compare == compare_side) {
        imageStore(target, at, vec4(graded_a(c), 1.0));
        imageStore(target, at + ivec2(size.x, 0), vec4(graded_b(c), 1.0));
    } else {
        float difference = delta_e_2000(saturate(graded_a(c)), saturate(graded_b(c)));
        uint bin = min(uint(difference * bins_per_unit), figure_bins - 1u);
        if (bin > 0u)
            atomicAdd(figures_out.bins[bin], 1u);
        if (floatBitsToUint(difference) > figures_out.largest)
            atomicMax(figures_out.largest, floatBitsToUint(difference));
        vec3 color = with_scale(heat(difference / push.heat_scale), at, size, push.heat_scale);
        imageStore(target, at, vec4(color, 1.0));
    }
}
