// Lays what is blurred over the sharp picture: behind the focus in place of it, before the focus over
// it. reference/depth_of_field.cpp gathers the same from every texel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/lens.glsl"
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(constant_id = 0) const int cell_side = 2;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) uniform sampler2D rest; // by cells, and radius in them; -1: nothing is known
layout(binding = 3) uniform sampler2D near; // the same, and opacity
layout(binding = 4) writeonly uniform image2D target;

#define a_texel (1.0 / float(cell_side)) // in cells

/// Between the four texels about it, of those that are known; alpha: whether any is.
vec4 rest_at(ivec2 at, bool is_far) {
    vec2 place = (vec2(at) + 0.5) * a_texel - 0.5;
    vec2 low = floor(place), f = place - low;
    ivec2 last = textureSize(rest, 0) - 1;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec4 texel = texelFetch(rest, clamp(ivec2(low) + corner, ivec2(0), last), 0);
        vec2 share = mix(1.0 - f, f, vec2(corner));
        // A sharp texel beside a blurred one is no part of its blur.
        float weight =
            texel.a < 0.0 ? 0.0 : share.x * share.y * (is_far ? 1e-5 + min(texel.a, a_texel) : 1.0);
        sum += weight * texel.rgb;
        weights += weight;
    }
    return weights > 0.0 ? vec4(sum / weights, 1.0) : vec4(0.0);
}

vec3 focused(ivec2 at, ivec2 size, float focus) {
    vec3 color = texelFetch(source, at, 0).rgb;
    float radius = radius_of(texelFetch(depths, at, 0).r, focus);
    vec4 before = textureLod(near, (vec2(at) + 0.5) * a_texel / vec2(textureSize(near, 0)), 0.0);
    float blur = max(far_share(radius), near_share(radius));
    bool is_known = true;
    if (blur > 0.0) {
        vec4 behind = rest_at(at, radius > 0.0);
        is_known = behind.a > 0.0;
        color = is_known ? mix(color, behind.rgb, blur) : color;
    }
    if (before.a <= 0.0) {
        return color;
    }
    float opacity = is_known ? min(before.a, 1.0) : 1.0;
    return color * (1.0 - opacity) + before.rgb * (opacity / before.a);
}

void main() {
    ivec2 size = textureSize(source, 0);
    float focus = focus_of(depths);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            vec3 color = focused(at, size, focus);
            imageStore(target, at, vec4(round_to_half(min(color, half_max)), 1.0));
        }
    }
}
