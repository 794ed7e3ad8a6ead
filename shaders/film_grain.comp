// Film grain: noise between the points of a grid, another for each frame of the film, strongest in
// the middle tones and none in black and white. reference/grain.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/hash.glsl"
#include "common/luma.glsl"
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float amplitude; // standard deviation in the middle tones, of codes
    float cell;      // of the grid, in texels
    uint frame;
    uint is_colored;
    int side_width;
} push;

/// Of variance 1 everywhere, also between the points of the grid.
vec3 noise_at(vec2 place) {
    vec2 low = floor(place);
    vec2 f = place - low;
    vec4 weights = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        uvec2 point = uvec2(ivec2(low) + ivec2(i & 1, i >> 1));
        sum += weights[i] * triangular_of(pcg3d(uvec3(point, push.frame)));
    }
    return sum * sqrt(6.0 / dot(weights, weights));
}

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            vec3 color = saturate(texelFetch(source, at, 0).rgb);
            float luma = luma_of(color);
            vec3 noise =
                noise_at((vec2(at.x % push.side_width, at.y) + 0.5) / push.cell);
            noise = push.is_colored != 0u ? noise : noise.xxx;
            color += push.amplitude * 4.0 * luma * (1.0 - luma) * noise;
            imageStore(target, at, vec4(saturate(color), 1.0));
        }
    }
}
