// Shows the light that surfaces emit, encoded as sRGB.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/srgb.glsl"
#include "common/view_material.glsl"

vec3 shown_material(Material material) {
    vec3 light = material.emission_metalness.rgb;
    return as_numbers ? light : srgb_encode(saturate(light));
}
