// Both axes of a Gaussian whose texels on either side fit beside a tile in shared memory. A thread
// makes several neighbours of one line, so that it reads a texel once for all of them. As two passes
// would, it rounds between the axes. preview/passes/bloom.cpp lays out the weights.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
layout(local_size_x = 256) in;
layout(constant_id = 0) const int radius = 1; // at most 12
layout(constant_id = 1) const bool has_own = false;

const int threads = 256, most_radius = 12;
const ivec2 side = ivec2(32, 16);
const int x_each = 8, y_each = 2;

layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D own;
// What a texel of a thread's line weighs in each of the thread's results.
const int x_weights = 2 * (x_each + 2 * most_radius), y_weights = y_each + 2 * most_radius;
layout(std430, binding = 2) readonly buffer Weights { vec4 rows[x_weights + y_weights]; } weights;
layout(binding = 3) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float keep, own_scale; // of own
};

const int stride = 57; // odd: neighbours below each other lie in different banks
const int most_texels = (side.x + 2 * most_radius) * (side.y + 2 * most_radius);
const int texels_each = (most_texels + threads - 1) / threads;
shared vec4 rows[x_weights + y_weights];
shared uvec2 tile[(side.y + 2 * most_radius) * stride]; // as half floats

uvec2 packed(vec3 c) {
    return uvec2(packHalf2x16(c.rg), packHalf2x16(vec2(c.b, 0.0)));
}

vec3 at_place(int place) {
    uvec2 texel = tile[place];
    return vec3(unpackHalf2x16(texel.x), unpackHalf2x16(texel.y).x);
}

void main() {
    int thread = int(gl_LocalInvocationIndex);
    int columns = side.x + 2 * radius, lines = side.y + 2 * radius;
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * side;
    ivec2 size = imageSize(target);
    vec3 light[texels_each];
    for (int k = 0; k < texels_each; ++k) {
        int i = thread + k * threads;
        ivec2 at = corner + ivec2(i % columns, i / columns) - radius;
        light[k] = texelFetch(source, clamp(at, ivec2(0), size - 1), 0).rgb;
    }
    if (thread < x_weights + y_weights) {
        rows[thread] = weights.rows[thread];
    }
    for (int k = 0; k < texels_each; ++k) {
        int i = thread + k * threads;
        if (i < columns * lines) {
            tile[i / columns * stride + i % columns] = packed(light[k]);
        }
    }
    barrier();

    vec4 red[2], green[2], blue[2];
    for (int k = 0; k < 2; ++k) {
        red[k] = green[k] = blue[k] = vec4(0.0);
    }
    int first = thread % lines * stride + thread / lines * x_each;
    bool has_line = thread < lines * (side.x / x_each);
    if (has_line) {
        for (int j = 0; j < x_each + 2 * radius; ++j) {
            vec3 c = at_place(first + j);
            for (int k = 0; k < 2; ++k) {
                vec4 weight = rows[2 * j + k];
                red[k] += c.r * weight;
                green[k] += c.g * weight;
                blue[k] += c.b * weight;
            }
        }
    }
    barrier();
    if (has_line) {
        for (int k = 0; k < x_each; ++k) {
            vec3 c = vec3(red[k / 4][k % 4], green[k / 4][k % 4], blue[k / 4][k % 4]);
            tile[first + k] = packed(round_to_half(min(c, half_max)));
        }
    }
    barrier();

    vec3 sums[y_each];
    for (int k = 0; k < y_each; ++k) {
        sums[k] = vec3(0.0);
    }
    ivec2 place = ivec2(thread % side.x, thread / side.x * y_each);
    for (int j = 0; j < y_each + 2 * radius; ++j) {
        vec3 c = at_place((place.y + j) * stride + place.x);
        vec4 weight = rows[x_weights + j];
        sums[0] += c * weight.x;
        sums[1] += c * weight.y;
    }
    for (int k = 0; k < y_each; ++k) {
        ivec2 at = corner + place + ivec2(0, k);
        if (any(greaterThanEqual(at, size))) {
            continue;
        }
        if (has_own) {
            vec2 from = (vec2(at) + 0.5) * own_scale / vec2(textureSize(own, 0));
            sums[k] += textureLod(own, from, 0.0).rgb * keep;
        }
        imageStore(target, at, vec4(round_to_half(min(sums[k], half_max)), 1.0));
    }
}
