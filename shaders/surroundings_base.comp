// The surroundings as a small picture of all directions, each texel the mean of its area. What is
// made from it is made by surroundings_levels.comp and surroundings_harmonics.comp.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/sky.glsl"
#include "common/sphere.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const bool is_picture = false; // else the sky
layout(binding = 0) uniform Skies { Sky sky; };
layout(binding = 1) uniform sampler2D picture;
layout(binding = 2) writeonly uniform image2D target;

/// By 4x4 directions.
vec3 sky_mean(ivec2 at, ivec2 size) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 16; ++i) {
        vec2 place = vec2(at) + (vec2(i & 3, i >> 2) + 0.5) / 4.0;
        sum += sky_radiance(sky, sphere_direction(place / vec2(size)));
    }
    return sum / 16.0;
}

vec3 picture_mean(ivec2 at, ivec2 size) {
    ivec2 picture_size = textureSize(picture, 0);
    vec2 scale = vec2(picture_size) / vec2(size);
    vec2 low = vec2(at) * scale;
    vec2 high = low + scale;
    ivec2 last = min(ivec2(ceil(high)), picture_size) - 1;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = int(low.y); y <= last.y; ++y) {
        float height = min(float(y + 1), high.y) - max(float(y), low.y);
        for (int x = int(low.x); x <= last.x; ++x) {
            float weight = height * (min(float(x + 1), high.x) - max(float(x), low.x));
            sum += weight * sanitise(texelFetch(picture, ivec2(x, y), 0).rgb);
            weights += weight;
        }
    }
    return sum / max(weights, 1e-20);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    vec3 mean = is_picture ? picture_mean(at, size) : sky_mean(at, size);
    imageStore(target, at, vec4(round_to_half(sanitise(mean)), 1.0));
}
