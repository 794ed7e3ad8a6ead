// Shows how many lights a pixel evaluates, up to 16, with its scale.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/view.glsl"
#include "common/heat_map.glsl"

vec3 shown(vec4 texel) {
    if (as_numbers) {
        return texel.rrr;
    }
    return with_scale(heat(texel.r / 16.0), shown_at, textureSize(source, 0), 16.0);
}
