// Writes what the lighting needs to know of the nearest surface, and no more: GPUs without a
// display run fragment shaders on a small part of the chip.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/normal_filter.glsl"
layout(constant_id = 0) const bool filters_normals = false;
layout(location = 0) in vec3 normal;
layout(location = 1) flat in uint material;
layout(location = 0) out uvec2 out_normal;
layout(location = 1) out uint out_material;

void main() {
    vec3 unit = unit_or_up(normal);
    out_normal = to_bits(encode_octahedral(unit));
    out_material = material + 1u; // 0 is no surface
    if (filters_normals) {
        out_material |= pack_added(added_by(dFdx(unit), dFdy(unit)));
    }
}
