// The border between sides A and B, over a finished picture.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/tile.glsl"
#include "common/wipe.glsl"
layout(constant_id = 0) const bool is_box = false;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    vec4 wipe;
} push;

void main() {
    ivec2 size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            imageStore(target, at, on_wipe(is_box, at, size, push.wipe)
                                        ? vec4(1.0)
                                        : texelFetch(source, at, 0));
        }
    }
}
