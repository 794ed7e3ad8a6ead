// Writes what the lighting needs to know of the nearest surface, and no more: GPUs without a
// display run fragment shaders on a small part of the chip.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(location = 0) in vec3 normal;
layout(location = 1) flat in uint material;
layout(location = 0) out uvec2 out_normal;
layout(location = 1) out uint out_material;

void main() {
    out_normal = to_bits(encode_octahedral(unit_or_up(normal)));
    out_material = material + 1u; // 0 is no surface
}
