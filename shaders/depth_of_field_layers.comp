// Parts a picture by cells of cell_side by cell_side texels into what lies before the focus and the
// rest, so that neither blurs into the other, and finds the largest circle before the focus of each 16
// by 16 of those.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/lens.glsl"
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int cell_side = 2;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) writeonly uniform image2D rest;       // and radius in cells; -1: none
layout(binding = 3) writeonly uniform image2D near;       // times its share, and that
layout(binding = 4) writeonly uniform image2D near_radii; // in cells
layout(binding = 5) writeonly uniform image2D tiles;      // the largest of them

#define a_texel (1.0 / float(cell_side)) // in cells

shared uint largest_near;

void main() {
    if (gl_LocalInvocationIndex == 0) {
        largest_near = 0u;
    }
    barrier();
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = textureSize(source, 0);
    float focus = focus_of(depths);
    if (all(lessThan(at, imageSize(rest)))) {
        // Weights of what is hardly blurred: a sharp texel beside a blurred one stays out.
        const float least = 1e-5;
        vec4 rest_sum = vec4(0.0), near_sum = vec4(0.0);
        float rest_weights = 0.0, near_weights = 0.0, near_radius = 0.0;
        for (int i = 0; i < cell_side * cell_side; ++i) {
            ivec2 texel = min(cell_side * at + ivec2(i % cell_side, i / cell_side), size - 1);
            vec3 color = texelFetch(source, texel, 0).rgb;
            float radius = radius_of(texelFetch(depths, texel, 0).r, focus);
            float share = near_share(radius);
            float weight = (1.0 - share) * max(far_share(radius), least);
            rest_sum += weight * vec4(color, max(radius, 0.0));
            rest_weights += weight;
            near_sum += share * vec4(color, 1.0);
            near_radius += share * -radius;
        }
        near_radius = near_sum.a > 0.0 ? a_texel * near_radius / near_sum.a : 0.0;
        vec4 mean = rest_weights > 1e-6 ? rest_sum / rest_weights : vec4(0.0, 0.0, 0.0, -cell_side);
        imageStore(rest, at, vec4(round_to_half(mean.rgb), a_texel * mean.a));
        near_sum *= a_texel * a_texel;
        imageStore(near, at, vec4(round_to_half(near_sum.rgb), near_sum.a));
        imageStore(near_radii, at, vec4(near_radius));
        atomicMax(largest_near, floatBitsToUint(near_radius)); // floats above 0 order like their bits
    }
    barrier();
    if (gl_LocalInvocationIndex == 0) {
        imageStore(tiles, ivec2(gl_WorkGroupID.xy), vec4(uintBitsToFloat(largest_near)));
    }
}
