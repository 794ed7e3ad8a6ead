// Two halvings in one dispatch (preview/finish/bloom_dispatches.h): a group makes what it needs of the
// first in shared memory. As two passes would, it rounds between them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int tap_count = 1;

layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform Weights {
    vec4 taps[32]; // of the first: bilinear
    vec4 rows[4];  // of the second: the four by four texels about the target's
};
layout(binding = 2) writeonly uniform image2D target;
layout(push_constant) uniform Push { ivec2 middle; }; // size of what the first makes

const int side = 34, threads = 256; // the group's 32x32 texels and one around them
shared uvec2 tile[side * side];     // as half floats

void main() {
    int thread = int(gl_LocalInvocationIndex);
    vec2 texel = 1.0 / vec2(textureSize(source, 0));
    for (int i = thread; i < side * side; i += threads) {
        ivec2 at = ivec2(gl_WorkGroupID.xy) * 32 - 1 + ivec2(i % side, i / side);
        vec2 centre = (vec2(clamp(at, ivec2(0), middle - 1)) + 0.5) * 2.0;
        vec3 sum = vec3(0.0);
        for (int t = 0; t < tap_count; ++t) {
            sum += textureLod(source, (centre + taps[t].xy) * texel, 0.0).rgb * taps[t].z;
        }
        sum = round_to_half(min(sum, half_max));
        tile[i] = uvec2(packHalf2x16(sum.rg), packHalf2x16(vec2(sum.b, 0.0)));
    }
    barrier();

    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    vec3 sum = vec3(0.0);
    int first = int(gl_LocalInvocationID.y * side + gl_LocalInvocationID.x) * 2;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            uvec2 c = tile[first + y * side + x];
            sum += vec3(unpackHalf2x16(c.x), unpackHalf2x16(c.y).x) * rows[y][x];
        }
    }
    imageStore(target, at, vec4(round_to_half(min(sum, half_max)), 1.0));
}
