// Bloom's last filter, tone map, looks and comparison (common/finish.glsl), eight texels a thread.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/tile.glsl"

vec3 graded_a(vec3 c);
vec3 graded_b(vec3 c);
#include "common/bloom.glsl"
#include "common/finish.glsl"

vec3 graded_a(vec3 c) {
    return apply_lookup(lookup_a, picture_a, volume_a, shaper_a, look_a, c);
}

vec3 graded_b(vec3 c) {
    return apply_lookup(lookup_b, picture_b, volume_b, shaper_b, look_b, c);
}

void main() {
    ivec2 size = textureSize(picture, 0);
    vec3 texels[texels_each];
    for (int i = 0; i < texels_each; ++i)
        texels[i] = picture_at(min(tile_texel(i), size - 1));
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size)))
            store_texel(at, size, display_encoded(at, texels[i]));
    }
}
