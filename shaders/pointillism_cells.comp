// The mean colours of the cells of a grid over each side's picture, from up to 8x8 texels spread
// over a cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float cell; // in texels
    int side_width, columns; // of one side's picture and cells
    int samples; // along each axis
} push;

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
    imageStore(target, at, vec4(sum / float(push.samples * push.samples), 1.0));
}
