// Fills the gaps between the points of large discs: a tent of three by three texels as far apart as
// a third of those points.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D rest;
layout(binding = 1) uniform sampler2D near;
layout(binding = 2) uniform sampler2D reaches; // before the focus, of 16 by 16 texels
layout(binding = 3) writeonly uniform image2D rest_filled;
layout(binding = 4) writeonly uniform image2D near_filled;

const float of_radius = 2.0 / 7.0 / 2.0; // two points of a disc are 2/7 of its radius apart

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 last = textureSize(rest, 0) - 1;
    if (any(greaterThan(at, last))) {
        return;
    }
    vec4 own = texelFetch(rest, at, 0);
    int step = int(own.a * of_radius + 0.5);
    vec3 sum = own.rgb;
    if (step > 0) {
        float weights = 4.0;
        sum *= weights;
        for (int i = 0; i < 9; ++i) {
            ivec2 offset = ivec2(i % 3, i / 3) - 1;
            if (offset == ivec2(0)) {
                continue;
            }
            vec4 other = texelFetch(rest, clamp(at + step * offset, ivec2(0), last), 0);
            float weight = float((2 - abs(offset.x)) * (2 - abs(offset.y))) *
                           clamp(2.0 - 2.0 * abs(other.a - own.a) / own.a, 0.0, 1.0);
            sum += weight * other.rgb;
            weights += weight;
        }
        sum /= weights;
    }
    imageStore(rest_filled, at, vec4(round_to_half(sum), own.a));
    step = int(texelFetch(reaches, ivec2(gl_WorkGroupID.xy), 0).r * of_radius + 0.5);
    vec4 before = texelFetch(near, at, 0);
    if (step > 0) {
        before *= 0.25;
        for (int i = 0; i < 9; ++i) {
            ivec2 offset = ivec2(i % 3, i / 3) - 1;
            float weight = float((2 - abs(offset.x)) * (2 - abs(offset.y))) / 16.0;
            if (offset != ivec2(0)) {
                before +=
                    weight * texelFetch(near, clamp(at + step * offset, ivec2(0), last), 0);
            }
        }
    }
    imageStore(near_filled, at, vec4(round_to_half(before.rgb), before.a));
}
