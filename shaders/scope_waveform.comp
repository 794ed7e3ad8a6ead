// Counts the levels in the columns of a picture: of luma, or of red, green and blue. A group counts
// one column of the scope in shared memory, so that the result is stored without atomics. Flat
// areas would have every thread add to one place, so a thread adds a run of equal levels at once.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scope.glsl"
#include "common/scope_area.glsl"
layout(local_size_x = 256) in;
layout(constant_id = 1) const uint planes = 1u;

layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) writeonly buffer Counts { uint counts[]; };

shared uint bins[planes * levels];

void main() {
    uint column = gl_WorkGroupID.x, thread = gl_LocalInvocationIndex;
    for (uint plane = 0u; plane < planes; ++plane) {
        bins[plane * levels + thread] = 0u;
    }
    barrier();

    uint from = (column * push.total + push.columns - 1u) / push.columns;
    uint to = ((column + 1u) * push.total + push.columns - 1u) / push.columns;
    uint wide = to - from, texels = wide * push.height;
    uvec3 held = uvec3(0u), run = uvec3(0u);
    for (uint i = thread; i < texels; i += levels) {
        ivec2 at = texel_of(from + i % wide, i / wide);
        if (!is_counted(at)) {
            continue;
        }
        uvec3 codes = codes_of(texelFetch(picture, at, 0).rgb);
        if (planes == 1u) {
            codes.r = luma_of(codes);
        }
        for (uint plane = 0u; plane < planes; ++plane) {
            if (codes[plane] != held[plane]) {
                if (run[plane] > 0u) {
                    atomicAdd(bins[plane * levels + held[plane]], run[plane]);
                }
                held[plane] = codes[plane];
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
    for (uint plane = 0u; plane < planes; ++plane) {
        counts[(plane * push.columns + column) * levels + thread] = bins[plane * levels + thread];
    }
}
