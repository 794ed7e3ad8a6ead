// A finished picture as a row of preview/finish/picture_views.cpp shows it, with its legend in the
// lower left corner.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/glyphs.glsl"
#include "common/nearest_code.glsl"
#include "common/tile.glsl"
#include "rows/picture_views.glsl"
layout(constant_id = 0) const int row = 0;
layout(constant_id = 1) const bool rounds = true; // the target has 8 bits
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D before; // of the same size, or a stand-in
layout(binding = 2) writeonly uniform image2D target;
const int longest = 24, most_lines = 8;
layout(std430, binding = 3) readonly buffer Legend {
    ivec4 panel;              // x, y, width, height
    ivec4 sizes;              // texels of a dot, lines
    vec4 colors[most_lines];
    uint characters[];        // longest of each line
} legend;
layout(push_constant) uniform Push {
    float level;
} push;

const int line_height = 9; // dots

vec3 with_legend(vec3 color, ivec2 at) {
    ivec2 p = at - legend.panel.xy;
    if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, legend.panel.zw))) {
        return color;
    }
    int dot_size = legend.sizes.x, step = glyph_step * dot_size;
    p -= 2 * dot_size;
    int line = p.y / (line_height * dot_size);
    ivec2 in_line = p - ivec2(0, line * line_height * dot_size);
    if (any(lessThan(p, ivec2(0))) || line >= legend.sizes.y || in_line.y >= 7 * dot_size) {
        return vec3(0.04);
    }
    if (p.x < 7 * dot_size) {
        return legend.colors[line].rgb;
    }
    in_line -= ivec2(10, 0) * dot_size;
    int place = in_line.x / step;
    bool is_text = in_line.x >= 0 && place < longest;
    uint glyph = is_text ? legend.characters[line * longest + place] : ~0u;
    bool is_ink = glyph < uint(glyphs.length()) &&
                  in_glyph(in_line - ivec2(place * step, 0), glyph, dot_size);
    return is_ink ? vec3(1.0) : vec3(0.04);
}

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            ivec2 inside = min(at, textureSize(before, 0) - 1);
            Viewed v = Viewed(texelFetch(source, at, 0).rgb, texelFetch(before, inside, 0).rgb, at,
                              legend.sizes.x, push.level);
            vec3 color = with_legend(saturate(picture_view(row, v)), at);
            imageStore(target, at, vec4(rounds ? nearest_code(color) : color, 1.0));
        }
    }
}
