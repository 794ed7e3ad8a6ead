// Surfaces between purple and pink by their brightness, and behind them a checkerboard that moves.
// reference/vaporwave.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/luma.glsl"
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float strength;
    float field; // of the board, in texels
    float moved; // by so many fields, 0..2
    int side_width;
} push;

const vec3 dark = vec3(0.10, 0.02, 0.24), light = vec3(1.0, 0.76, 0.96);
const vec3 fields[2] = vec3[2](vec3(0.23, 0.07, 0.45), vec3(0.98, 0.36, 0.76));
const float kept_color = 0.3;

/// Within -1/2..1/2, changing sign from field to field over one texel.
float wave(float place) {
    float from_edge = 0.5 - abs(fract(0.5 * place) * 2.0 - 1.0);
    return clamp(from_edge * push.field, -0.5, 0.5);
}

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (any(greaterThanEqual(at, size))) {
            continue;
        }
        vec3 own = saturate(texelFetch(source, at, 0).rgb);
        int x = at.x % push.side_width;
        vec3 color = mix(mix(dark, light, luma_of(own)), own, kept_color);
        if (texelFetch(depths, ivec2(x, at.y), 0).r >= 1.0) {
            vec2 place = (vec2(x, at.y) + 0.5) / push.field + vec2(push.moved, 0.0);
            color = mix(fields[0], fields[1], 0.5 + 2.0 * wave(place.x) * wave(place.y));
        }
        imageStore(target, at, vec4(mix(own, color, push.strength), 1.0));
    }
}
