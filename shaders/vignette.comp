// Light falls off with the fourth power of the cosine of its angle to the axis (Gardner 1947). A
// pinhole's picture plane at distance 1 has its corner at tan(half the angle of view), so that
// cos^2 = 1 / (1 + (r corner_tangent)^2) at the share r of the way to the corner.
// reference/vignette.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(constant_id = 0) const bool is_half = true; // the target
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float strength, corner_tangent;
    int side_width; // of one picture; side by side there are two
} push;

float falloff(ivec2 at, ivec2 size) {
    vec2 half_size = 0.5 * vec2(push.side_width, size.y);
    vec2 from_centre = vec2(at.x % push.side_width, at.y) + 0.5 - half_size;
    float share = length(from_centre) / length(half_size);
    float tangent = share * push.corner_tangent;
    float cosine_squared = 1.0 / (1.0 + tangent * tangent);
    return mix(1.0, cosine_squared * cosine_squared, push.strength);
}

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            vec3 light = texelFetch(source, at, 0).rgb * falloff(at, size);
            imageStore(target, at, vec4(is_half ? round_to_half(light) : light, 1.0));
        }
    }
}
