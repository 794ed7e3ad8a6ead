// Shows the surfaces' albedo, encoded as sRGB.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/srgb.glsl"
#include "common/view_material.glsl"

vec3 shown_material(Material material) {
    vec3 albedo = material.albedo_roughness.rgb;
    return as_numbers ? albedo : srgb_encode(saturate(albedo));
}
