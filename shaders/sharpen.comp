// Contrast-adaptive sharpening after AMD's FidelityFX CAS, with the cross of four neighbours: the
// nearer a neighbourhood is to black or white, or the more contrast it has, the less it gains.
// reference/sharpen.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float strength;
    int reach; // of the neighbours, in texels
    int side_width;
} push;

ivec2 size;

vec3 color_at(ivec2 at, int left) {
    return saturate(texelFetch(source,
                               ivec2(clamp(at.x, left, left + push.side_width - 1),
                                     clamp(at.y, 0, size.y - 1)),
                               0)
                        .rgb);
}

vec3 sharpened(ivec2 at) {
    int left = at.x / push.side_width * push.side_width;
    vec3 own = color_at(at, left);
    vec3 n = color_at(at - ivec2(0, push.reach), left), s = color_at(at + ivec2(0, push.reach), left);
    vec3 w = color_at(at - ivec2(push.reach, 0), left), e = color_at(at + ivec2(push.reach, 0), left);
    vec3 least = min(own, min(min(n, s), min(w, e)));
    vec3 most = max(own, max(max(n, s), max(w, e)));
    vec3 room = min(least, 1.0 - most) / max(most, vec3(1e-4));
    vec3 weight = -0.2 * sqrt(saturate(room));
    vec3 sharp = saturate((own + weight * (n + s + w + e)) / (1.0 + 4.0 * weight));
    return mix(own, sharp, push.strength);
}

void main() {
    size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            imageStore(target, at, vec4(sharpened(at), 1.0));
        }
    }
}
