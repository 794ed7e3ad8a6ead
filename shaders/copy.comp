// Copies an image texel by texel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/nearest_code.glsl"
#include "common/tile.glsl"
layout(constant_id = 0) const bool rounds = false; // the target has 8 bits
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;

void main() {
    ivec2 size = imageSize(target);
    vec4 texels[texels_each];
    for (int i = 0; i < texels_each; ++i) {
        texels[i] = texelFetch(source, min(tile_texel(i), size - 1), 0);
    }
    for (int i = 0; i < texels_each; ++i) {
        if (all(lessThan(tile_texel(i), size))) {
            vec3 color = rounds ? nearest_code(texels[i].rgb) : texels[i].rgb;
            imageStore(target, tile_texel(i), vec4(color, texels[i].a));
        }
    }
}
