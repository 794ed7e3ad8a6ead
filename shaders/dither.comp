// Rounds to 8 bits by a mask of high spatial frequencies, another for each channel: the additive
// sequence R2 (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences") over the
// texels. Noise within half a code leaves what is a code already as it is.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;

const float reach = 0.49; // less than a half by more than a float of 255 rounds

/// Evenly spread over -1/2..1/2.
vec3 mask_at(ivec2 at) {
    // 2^32 over the plastic number and over its square.
    uint turn = uint(at.x) * 3242174889u + uint(at.y) * 2447445414u;
    uvec3 turns = uvec3(turn, turn + 1431655765u, turn + 2863311531u);
    return vec3(turns >> 8u) / 16777216.0 - 0.5;
}

void main() {
    ivec2 size = imageSize(target);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            vec3 codes = saturate(texelFetch(source, at, 0).rgb) * 255.0;
            imageStore(target, at,
                       vec4(floor(codes + 0.5 + 2.0 * reach * mask_at(at)) / 255.0, 1.0));
        }
    }
}
