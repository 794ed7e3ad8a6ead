// The names of two looks in the upper corners of a finished picture.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/glyphs.glsl"
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(std430, binding = 2) readonly buffer Names {
    ivec4 panels[2]; // x, y, width, height of what lies under a name
    ivec4 dot_size;  // x
    uint characters[]; // longest of each
} names;
const int longest = 40;

vec4 named(vec4 color, ivec2 at) {
    int dot_size = names.dot_size.x, step = glyph_step * dot_size;
    for (int side = 0; side < 2; ++side) {
        ivec2 p = at - names.panels[side].xy;
        if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, names.panels[side].zw))) {
            continue;
        }
        p -= 2 * dot_size;
        int place = p.x / step;
        uint glyph = p.x >= 0 && place < longest ? names.characters[side * longest + place] : ~0u;
        bool is_ink = glyph < uint(glyphs.length()) &&
                      in_glyph(p - ivec2(place * step, 0), glyph, dot_size);
        return vec4(is_ink ? vec3(1.0) : 0.35 * color.rgb, color.a);
    }
    return color;
}

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            imageStore(target, at, named(texelFetch(source, at, 0), at));
        }
    }
}
