// Lateral chromatic aberration: a lens shows red a little smaller and blue a little larger than
// green, the more the farther from its axis. reference/lens.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(constant_id = 0) const bool is_half = true; // the target
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float corner; // how far red and blue are from green in a corner, of half the diagonal
    int side_width;
} push;

void main() {
    ivec2 size = textureSize(source, 0);
    vec2 half_size = 0.5 * vec2(push.side_width, size.y);
    float scale = push.corner / dot(half_size, half_size);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            int left = at.x / push.side_width * push.side_width;
            vec2 origin = vec2(float(left), 0.0) + half_size;
            vec2 from_centre = vec2(at) + 0.5 - origin;
            vec2 shift = from_centre * scale * dot(from_centre, from_centre);
            vec2 reach = half_size - 0.5;
            vec2 red = origin + clamp(from_centre + shift, -reach, reach);
            vec2 blue = origin + clamp(from_centre - shift, -reach, reach);
            vec3 color = vec3(textureLod(source, red / vec2(size), 0.0).r,
                              texelFetch(source, at, 0).g,
                              textureLod(source, blue / vec2(size), 0.0).b);
            imageStore(target, at, vec4(is_half ? round_to_half(color) : color, 1.0));
        }
    }
}
