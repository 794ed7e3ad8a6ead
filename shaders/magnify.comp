// A part of a finished picture in the output, each of its pixels `scale` large, on a grey surround.
// Twin: preview/reference/magnify.cpp.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/heat_map.glsl"
#include "common/nearest_code.glsl"
#include "common/tile.glsl"
layout(constant_id = 0) const bool is_smooth = false;
layout(constant_id = 1) const bool is_pair = false; // both images are two, side by side
layout(constant_id = 2) const bool has_scale = false; // of a heat map, drawn over it
layout(constant_id = 3) const bool rounds = false;    // the target has 8 bits
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    ivec2 corner;   // of the picture, in the target
    int half_width; // of the target, where it is a pair
    float scale;    // pixels of the target to one of the source
    float surround; // its grey, as a code
    float heat_scale;
} push;

/// Texels of the picture `offset` columns into the source, which goes on beyond its border.
vec4 texel(ivec2 at, ivec2 size, int offset) {
    return texelFetch(source, clamp(at, ivec2(0), size - 1) + ivec2(offset, 0), 0);
}

vec4 magnified(ivec2 at) {
    ivec2 size = textureSize(source, 0);
    int offset = 0;
    if (is_pair) {
        size.x /= 2;
        offset = at.x >= push.half_width ? size.x : 0;
        at.x = at.x >= push.half_width ? at.x - push.half_width : at.x;
    }
    vec2 place = (vec2(at - push.corner) + 0.5) / push.scale;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, vec2(size)))) {
        return vec4(vec3(push.surround), 1.0);
    }
    if (!is_smooth) {
        return texel(ivec2(place), size, offset);
    }
    vec2 between = place - 0.5;
    ivec2 first = ivec2(floor(between));
    vec2 share = between - vec2(first);
    vec4 upper = mix(texel(first, size, offset), texel(first + ivec2(1, 0), size, offset), share.x);
    vec4 lower = mix(texel(first + ivec2(0, 1), size, offset),
                     texel(first + ivec2(1, 1), size, offset), share.x);
    return mix(upper, lower, share.y);
}

void main() {
    ivec2 size = imageSize(target);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            vec4 color = magnified(at);
            if (has_scale) {
                color.rgb = with_scale(color.rgb, at, size, push.heat_scale);
            }
            imageStore(target, at, vec4(rounds ? nearest_code(color.rgb) : color.rgb, color.a));
        }
    }
}
