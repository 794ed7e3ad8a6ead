// A background without a scene's sense: hue and value of the moment, saturation from noise over
// the directions. preview/reference/noise.h is the same in double.
#ifndef NOISE_GLSL
#define NOISE_GLSL
#include "common/srgb.glsl"

/// Jarzynski and Olano 2020, "Hash functions for GPU rendering": pcg3d.
uint noise_hash(ivec3 cell) {
    uvec3 v = uvec3(cell & 255) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return v.x;
}

/// The slope at a corner of the lattice: one of twelve directions.
float noise_slope(ivec3 cell, vec3 from) {
    uint h = noise_hash(cell) >> 28u;
    float u = h < 8u ? from.x : from.y;
    float v = h < 4u ? from.y : h == 12u || h == 14u ? from.x : from.z;
    return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}

/// Perlin 2002, "Improving noise"; within -1..1, 0 at the lattice's corners, which repeat after
/// 256.
float perlin(vec3 p) {
    vec3 low = floor(p);
    vec3 f = p - low;
    ivec3 cell = ivec3(low);
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float corners[8];
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, i >> 1 & 1, i >> 2);
        corners[i] = noise_slope(cell + corner, f - vec3(corner));
    }
    vec4 along_x = mix(vec4(corners[0], corners[2], corners[4], corners[6]),
                       vec4(corners[1], corners[3], corners[5], corners[7]), w.x);
    vec2 along_y = mix(along_x.xz, along_x.yw, w.y);
    return mix(along_y.x, along_y.y, w.z);
}

/// Five octaves, each half as strong and twice as fine.
float noise_sum(vec3 p) {
    float sum = 0.0;
    float strength = 0.5;
    for (int octave = 0; octave < 5; ++octave) {
        sum += strength * perlin(p);
        p *= 2.0;
        strength *= 0.5;
    }
    return sum;
}

/// Smith 1978, "Color gamut transform pairs"; hue 0..1.
vec3 rgb_of_hsv(float hue, float saturation, float value) {
    vec3 k = mod(vec3(5.0, 3.0, 1.0) + hue * 6.0, 6.0);
    return value * (1.0 - saturation * clamp(min(k, 4.0 - k), 0.0, 1.0));
}

/// Light from a direction. `noise`: hue, value, scale of the noise, and how far it has moved.
vec3 noise_background(vec4 noise, vec3 direction) {
    float sum = noise_sum(direction * noise.z + vec3(0.0, 0.0, noise.w));
    return srgb_decode(rgb_of_hsv(noise.x, clamp(0.5 + 1.5 * sum, 0.0, 1.0), noise.y));
}

#endif
