// The dots of shaders/pointillism.comp: their ink and radius, in cells, from the mean of up to 8x8
// texels spread over each cell of a grid over each side's picture.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/luma.glsl"
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float cell; // in texels
    int side_width, columns; // of one side's picture and cells
    int samples; // along each axis
    uint is_colored;
} push;

/// Of a dot that covers that share of its cell, in cells. Up to pi / 4 it lies within; from there to
/// 1 it grows into the corners.
float radius_of(float share) {
    const float whole = 0.78539816;
    if (share <= whole) {
        return sqrt(share / 3.14159265);
    }
    return 0.5 + 0.20710678 * (1.0 - sqrt(max(1.0 - share, 0.0) / (1.0 - whole)));
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    ivec2 size = ivec2(push.side_width, textureSize(source, 0).y);
    int column = at.x % push.columns, left = at.x / push.columns * push.side_width;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < push.samples; ++y) {
        for (int x = 0; x < push.samples; ++x) {
            vec2 place =
                (vec2(column, at.y) + (vec2(x, y) + 0.5) / float(push.samples)) * push.cell;
            ivec2 texel = min(ivec2(place), size - 1);
            sum += saturate(texelFetch(source, texel + ivec2(left, 0), 0).rgb);
        }
    }
    vec3 mean = sum / float(push.samples * push.samples);
    bool is_colored = push.is_colored != 0u;
    float share = is_colored ? 1.0 - min(mean.r, min(mean.g, mean.b)) : 1.0 - luma_of(mean);
    vec3 ink = is_colored ? saturate(1.0 - (1.0 - mean) / max(share, 1e-4)) : vec3(0.0);
    imageStore(target, at, vec4(ink, radius_of(share)));
}
