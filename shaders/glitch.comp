// A damaged transmission: green stands apart from red and blue, the more the nearer to the left and
// right borders; some lines are torn sideways; static lies over all. What happens changes from step
// to step of the time. reference/glitch.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/hash.glsl"
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float green_shift; // at the borders, in texels
    float tear;        // the farthest of a line, in texels
    float torn_lines;  // share of the lines
    float noise;       // amplitude, of codes
    uint moment;       // number of the step
    int line;          // height of a line and side of a grain of the static, in texels
    int side_width;
} push;

const uint of_lines = 0x6c696e65u; // sets their numbers apart from those of the static

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (any(greaterThanEqual(at, size))) {
            continue;
        }
        int x = at.x % push.side_width, left = at.x - x;
        uvec2 cell = uvec2(x, at.y) / uint(push.line);
        vec3 of_line = unit_of(pcg3d(uvec3(of_lines, cell.y, push.moment)));
        int torn = of_line.x < push.torn_lines
                       ? int(floor(push.tear * (2.0 * of_line.y - 1.0) + 0.5))
                       : 0;
        float to_border = 2.0 * (float(x) + 0.5) / float(push.side_width) - 1.0;
        int green = int(floor(push.green_shift * to_border * abs(to_border) + 0.5));
        int most = push.side_width - 1;
        vec3 color = texelFetch(source, ivec2(left + clamp(x + torn, 0, most), at.y), 0).rgb;
        color.g =
            texelFetch(source, ivec2(left + clamp(x + torn + green, 0, most), at.y), 0).g;
        float grain = triangular_of(pcg3d(uvec3(cell, push.moment))).x;
        imageStore(target, at, vec4(saturate(color + push.noise * grain), 1.0));
    }
}
