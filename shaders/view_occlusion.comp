// Shows the ambient occlusion as grey.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/view.glsl"

vec3 shown(vec4 texel) {
    return texel.rrr;
}
