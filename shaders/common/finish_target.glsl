// The picture that finish.comp and finish_shared.comp make, and what they count on the way.
#include "common/finish.glsl"
#include "rows/compares.glsl"

layout(binding = 16) writeonly uniform image2D target;
layout(binding = 17) buffer Figures {
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

void store_texel(ivec2 at, ivec2 size, Stages texel) {
    show(compare, target, at, size, texel, Shown(push.split, has_line, push.heat_scale));
}
