// Bloom's last filter, tone map, looks and comparison (common/finish.glsl), eight texels a thread.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/tile.glsl"
#include "common/finish.glsl"
#include "common/graded.glsl"
#include "common/finish_target.glsl"

void main() {
    ivec2 size = textureSize(picture, 0);
    vec3 texels[texels_each];
    for (int i = 0; i < texels_each; ++i) {
        texels[i] = picture_at(min(tile_texel(i), size - 1));
    }
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            store_texel(at, size, stages_of(at, texels[i]));
        }
    }
}
