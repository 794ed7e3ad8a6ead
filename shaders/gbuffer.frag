// Writes what the lighting needs to know of the nearest surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };
layout(location = 0) in vec3 normal;
layout(location = 1) flat in uint material;
layout(location = 0) out uvec2 out_normal;
layout(location = 1) out vec4 out_albedo;
layout(location = 2) out vec4 out_material;
layout(location = 3) out vec4 out_emission;

void main() {
    Material m = materials[material];
    out_normal = to_bits(encode_octahedral(unit_or_up(normal)));
    out_albedo = vec4(m.albedo_roughness.rgb, 1.0);
    out_material = vec4(m.albedo_roughness.a, m.emission_metalness.a, 0.0, 0.0);
    out_emission = vec4(m.emission_metalness.rgb, 1.0);
}
