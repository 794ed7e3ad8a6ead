// One step of a bloom plan (preview/finish/blooms.h): a sum of bilinear fetches.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/stored.glsl"
#include "common/bloom.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int tap_count = 1;
layout(constant_id = 1) const bool prefilter = false;
layout(constant_id = 2) const bool karis = false; // groups of four taps
layout(constant_id = 3) const bool has_own = false;
layout(constant_id = 4) const int stored = 0;

layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D own; // as large as the target
layout(binding = 2) uniform Taps { vec4 taps[32]; };
layout(binding = 3) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float scale;
    float keep; // weight of own
    BloomOnset onset;
} push;

float largest(vec3 c) {
    return max(c.r, max(c.g, c.b));
}

vec3 fetch(vec2 at, vec2 texel) {
    vec3 light = textureLod(source, at * texel, 0.0).rgb;
    return prefilter ? light * bloom_share(largest(light), push.onset) : light;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    vec2 texel = 1.0 / vec2(textureSize(source, 0));
    vec2 centre = (vec2(at) + 0.5) * push.scale;
    vec3 sum = vec3(0.0);
    if (karis) {
        float total = 0.0;
        for (int i = 0; i < tap_count; i += 4) {
            vec3 group = vec3(0.0);
            float weight = 0.0;
            for (int j = i; j < i + 4; ++j) {
                group += fetch(centre + taps[j].xy, texel) * taps[j].z;
                weight += taps[j].z;
            }
            float damping = 1.0 / (1.0 + largest(group) / weight);
            sum += group * damping;
            total += weight * damping;
        }
        sum /= total;
    } else {
        for (int i = 0; i < tap_count; ++i) {
            sum += fetch(centre + taps[i].xy, texel) * taps[i].z;
        }
    }
    if (has_own) {
        sum += texelFetch(own, at, 0).rgb * push.keep;
    }
    imageStore(target, at, vec4(as_stored(sum, stored), 1.0));
}
