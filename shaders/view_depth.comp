// Shows depth: near is bright, ten doublings of the distance from white to black.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/view.glsl"

// Depth is 1 - near / z; the numbers are z in metres, 0 where there is nothing.
vec3 shown(vec4 texel) {
    if (as_numbers) {
        return vec3(texel.r < 1.0 ? view_push.near_plane / (1.0 - texel.r) : 0.0);
    }
    return vec3(texel.r < 1.0 ? 1.0 + log2(1.0 - texel.r) / 10.0 : 0.0);
}
