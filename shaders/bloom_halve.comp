// A halving by weights for single texels, the four by four about the target's
// (preview/finish/blooms.h): each texel is fetched and prefiltered once for the group instead of
// once for each of the four targets that it belongs to. Fetches at a stride of two texels are slow
// for texture units.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/stored.glsl"
#include "common/bloom.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const bool prefilter = false;
layout(constant_id = 1) const int stored = 0;

layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform Weights { vec4 rows[4]; };
layout(binding = 2) writeonly uniform image2D target;
layout(push_constant) uniform Push { BloomOnset onset; };

const int side = 34; // the group's 32x32 texels and one around them
const int threads = 256;
const int texels_each = (side * side + threads - 1) / threads;
shared uvec2 tile[texels_each * threads]; // as half floats

void main() {
    int thread = int(gl_LocalInvocationIndex);
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * 32 - 1, last = textureSize(source, 0) - 1;
    vec3 light[texels_each];
    for (int k = 0; k < texels_each; ++k) {
        int i = thread + k * threads;
        ivec2 place = clamp(corner + ivec2(i % side, i / side), ivec2(0), last);
        light[k] = texelFetch(source, place, 0).rgb;
    }
    for (int k = 0; k < texels_each; ++k) {
        vec3 c = light[k];
        if (prefilter) {
            float share = bloom_share(max(c.r, max(c.g, c.b)), onset);
            c = share > 0.0 ? round_to_half(c * share) : vec3(0.0);
        }
        tile[thread + k * threads] = uvec2(packHalf2x16(c.rg), packHalf2x16(vec2(c.b, 0.0)));
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
            uvec2 texel = tile[first + y * side + x];
            sum += vec3(unpackHalf2x16(texel.x), unpackHalf2x16(texel.y).x) * rows[y][x];
        }
    }
    imageStore(target, at, vec4(as_stored(sum, stored), 1.0));
}
