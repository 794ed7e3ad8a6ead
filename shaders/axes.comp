// Counts the colours of a picture before its looks along the axes of the operators' curves
// (preview/finish/curve_counts.h). Groups count in shared memory and add their sums to the buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/finish.glsl"
layout(local_size_x = 256) in;

const uint axes = 7u, bins_each = 128u;
const int light_steps = 1024, dial_steps = 512;
const float hue_unit = 64.0;
const float srgb_chroma = 0.3225;

layout(std430, binding = 13) readonly buffer Tables {
    vec4 cones[3];
    float light[light_steps + 1];
    float dial[dial_steps + 1];
} tables;
layout(std430, binding = 14) buffer Counts { uint counts[]; };

shared uint bins[axes * bins_each];

float light_of(float code) {
    float at = code * float(light_steps);
    int i = min(int(at), light_steps - 1);
    return mix(tables.light[i], tables.light[i + 1], at - float(i));
}

/// In turns of the dial, half a bin on.
float hue_of_angle(float angle) {
    float at = (angle / 6.28318530717959 + 0.5) * float(dial_steps);
    int i = clamp(int(at), 0, dial_steps - 1);
    float hue = mix(tables.dial[i], tables.dial[i + 1], at - float(i)) / 360.0;
    hue += 0.5 / float(bins_each); // the bins' middles are at 0, 360 / 128...
    return hue - floor(hue);
}

vec3 oklab_of(vec3 codes) {
    vec3 light = vec3(light_of(codes.r), light_of(codes.g), light_of(codes.b));
    vec3 lms = vec3(dot(tables.cones[0].xyz, light), dot(tables.cones[1].xyz, light),
                    dot(tables.cones[2].xyz, light));
    lms = sign(lms) * pow(abs(lms), vec3(1.0 / 3.0));
    return vec3(dot(vec3(0.21045427, 0.79361777, -0.00407204), lms),
                dot(vec3(1.97799853, -2.42859224, 0.45059371), lms),
                dot(vec3(0.02590404, 0.78277171, -0.80867575), lms));
}

/// `share` of the axis; the last bin takes what rounding puts above 1.
void add(uint axis, float share, uint count) {
    if (count > 0u && share >= 0.0 && share <= 1.0001) {
        atomicAdd(bins[axis * bins_each + min(uint(share * float(bins_each)), bins_each - 1u)],
                  count);
    }
}

void count(vec3 color) {
    vec3 codes = saturate(color);
    vec3 lab = oklab_of(codes);
    float chroma = length(lab.yz), half_chroma = 0.1 * srgb_chroma;
    float weight = chroma * chroma / (chroma * chroma + half_chroma * half_chroma);
    add(0u, lab.x, 1u);
    add(1u, chroma / srgb_chroma, 1u);
    if (chroma > 1e-5) {
        add(2u, hue_of_angle(atan(lab.z, lab.y)), uint(weight * hue_unit + 0.5));
    }
    add(3u, dot(codes, vec3(0.2126, 0.7152, 0.0722)), 1u);
    for (int channel = 0; channel < 3; ++channel) {
        add(4u + uint(channel), codes[channel], 1u);
    }
}

void main() {
    const uint threads = gl_WorkGroupSize.x;
    for (uint i = gl_LocalInvocationIndex; i < axes * bins_each; i += threads) {
        bins[i] = 0u;
    }
    barrier();
    uvec2 size = uvec2(textureSize(picture, 0));
    for (uint i = gl_GlobalInvocationID.x; i < size.x * size.y; i += threads * gl_NumWorkGroups.x) {
        ivec2 at = ivec2(i % size.x, i / size.x);
        count(stages_of(at, picture_at(at)).codes);
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < axes * bins_each; i += threads) {
        if (bins[i] > 0u) {
            atomicAdd(counts[i], bins[i]);
        }
    }
}
