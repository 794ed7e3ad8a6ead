// Counts the codes of a picture, in red, green, blue and luma. Each group counts in shared memory
// and adds its sums to the buffer. A thread adds a run of equal codes at once.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scope.glsl"
#include "common/scope_area.glsl"
layout(local_size_x = 256) in;

layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) buffer Counts { uint counts[]; };

const uint planes = 4u;
shared uint bins[planes * levels];

void main() {
    const uint threads = gl_WorkGroupSize.x;
    for (uint i = gl_LocalInvocationIndex; i < planes * levels; i += threads) {
        bins[i] = 0u;
    }
    barrier();

    uint texels = push.total * push.height;
    uvec4 held = uvec4(0u), run = uvec4(0u);
    for (uint i = gl_GlobalInvocationID.x; i < texels; i += threads * gl_NumWorkGroups.x) {
        ivec2 at = texel_of(i % push.total, i / push.total);
        if (!is_counted(at)) {
            continue;
        }
        uvec3 codes = codes_of(texelFetch(picture, at, 0).rgb);
        uvec4 all_codes = uvec4(codes, luma_of(codes));
        for (uint plane = 0u; plane < planes; ++plane) {
            if (all_codes[plane] != held[plane]) {
                if (run[plane] > 0u) {
                    atomicAdd(bins[plane * levels + held[plane]], run[plane]);
                }
                held[plane] = all_codes[plane];
                run[plane] = 0u;
            }
            ++run[plane];
        }
    }
    for (uint plane = 0u; plane < planes; ++plane) {
        if (run[plane] > 0u) {
            atomicAdd(bins[plane * levels + held[plane]], run[plane]);
        }
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < planes * levels; i += threads) {
        if (bins[i] > 0u) {
            atomicAdd(counts[i], bins[i]);
        }
    }
}
