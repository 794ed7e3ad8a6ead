// As gbuffer.frag, for scenes with textures: what they make of the surface is written, for the
// lighting knows of no texture.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#define DETAIL_BINDING 5
#include "common/detail_surface.glsl"
#include "common/normal_filter.glsl"
#include "common/sanitise.glsl"
layout(constant_id = 0) const bool filters_normals = false;
layout(std430, binding = 4) readonly buffer Materials { Material materials[]; };
layout(location = 0) in vec3 normal;
layout(location = 1) flat in uint material;
layout(location = 2) in vec4 uv;
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 tangent;
layout(location = 0) out uvec2 out_normal;
layout(location = 1) out uint out_material;
layout(location = 2) out vec4 out_albedo;
layout(location = 3) out vec4 out_emission;

void main() {
    Footprint at = Footprint(uv, dFdx(uv), dFdy(uv));
    vec3 turned = unit_or_up(normal);
    float added = filters_normals ? added_by(dFdx(turned), dFdy(turned)) : 0.0;
    float coverage;
    Surface s = surface_of(materials[material], material, at, color, tangent, turned, coverage);
    float least_coverage = material_details[material].least_coverage;
    if (least_coverage > 0.0 && coverage < least_coverage) {
        discard;
    }
    s.roughness = filtered_roughness(s.roughness, added);
    out_normal = to_bits(encode_octahedral(turned));
    out_material = pack_surface(s);
    out_albedo = vec4(round_to_half(s.albedo), 1.0);
    out_emission = vec4(round_to_half(s.emission), 1.0);
}
