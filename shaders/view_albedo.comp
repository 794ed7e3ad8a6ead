// Shows the surfaces' albedo, encoded as sRGB.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/srgb.glsl"
#include "common/view_material.glsl"

vec3 shown_material(Material material) {
    return srgb_encode(saturate(material.albedo_roughness.rgb));
}
