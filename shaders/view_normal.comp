// Shows octahedral normals as n / 2 + 1/2.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VIEW_UNSIGNED
#include "common/scene.glsl"
#include "common/view.glsl"

vec3 shown(uvec4 texel) {
    bool is_empty = texel.xy == uvec2(0);
    vec3 normal = is_empty ? vec3(0.0) : decode_octahedral(from_bits(texel.xy));
    return as_numbers ? normal : is_empty ? vec3(0.0) : normal * 0.5 + 0.5;
}
