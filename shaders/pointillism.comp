// A dot in each cell of a grid on white paper, so large that ink and paper together have the cell's
// mean colour. The largest dot reaches its cell's corners, so that nine cells decide a texel.
// reference/pointillism.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D cells; // ink, and radius in cells
layout(binding = 2) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float strength;
    float cell; // in texels
    int side_width, columns;
} push;

void main() {
    ivec2 size = textureSize(source, 0);
    int rows = textureSize(cells, 0).y;
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (any(greaterThanEqual(at, size))) {
            continue;
        }
        int side = at.x / push.side_width;
        vec2 place = (vec2(at.x - side * push.side_width, at.y) + 0.5) / push.cell;
        ivec2 own_cell = ivec2(place);
        vec3 color = vec3(1.0);
        for (int n = 0; n < 9; ++n) {
            ivec2 other = own_cell + ivec2(n % 3, n / 3) - 1;
            if (any(lessThan(other, ivec2(0))) || other.x >= push.columns || other.y >= rows) {
                continue;
            }
            vec4 dot_there = texelFetch(cells, other + ivec2(side * push.columns, 0), 0);
            float radius = dot_there.a * push.cell; // in texels
            float away = length(place - vec2(other) - 0.5) * push.cell;
            // What is smaller than a texel covers no more of it than it is large.
            float inside =
                clamp(radius - away + 0.5, 0.0, 1.0) * min(3.14159265 * radius * radius, 1.0);
            color = mix(color, dot_there.rgb, inside);
        }
        vec3 own = saturate(texelFetch(source, at, 0).rgb);
        imageStore(target, at, vec4(mix(own, color, push.strength), 1.0));
    }
}
