// Shows linear light, encoded as sRGB.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/srgb.glsl"
#include "common/view.glsl"

vec3 shown(vec4 texel) {
    return as_numbers ? texel.rgb : srgb_encode(saturate(texel.rgb));
}
