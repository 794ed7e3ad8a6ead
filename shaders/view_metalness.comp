// Shows the surfaces' metalness as grey.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/view_material.glsl"

vec3 shown_material(Material material) {
    return material.emission_metalness.aaa;
}
