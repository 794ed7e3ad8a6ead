// All of a surface at a point. After common/scene.glsl; who includes this defines DETAIL_BINDING.
#include "common/detail.glsl"
#include "common/surface.glsl"

/// `tangent.w`: its side, as VertexDetail has it. Turns the normal.
Surface surface_of(Material material, MaterialDetail detail, Footprint at, vec4 color,
                   vec4 tangent, inout vec3 normal) {
    Surface s;
    s.albedo = clamp(base_of(material.albedo_roughness.rgb, detail, at, color).rgb, 0.0, 1.0);
    s.roughness = material.albedo_roughness.a;
    s.metalness = material.emission_metalness.a;
    s.emission = material.emission_metalness.rgb;
    s.occlusion = 1.0;
    s.is_unlit = detail.is_unlit.x != 0u;
    if (s.is_unlit) {
        s.emission = s.albedo;
        return s;
    }
    vec4 texel = read_texture(detail.surface, at);
    s.roughness *= texel.g;
    s.metalness *= texel.b;
    s.occlusion += detail.occlusion_strength * (read_texture(detail.occlusion, at).r - 1.0);
    s.emission *= read_texture(detail.emission, at).rgb;
    vec3 along = tangent.xyz - normal * dot(normal, tangent.xyz);
    if (detail.normal.number != no_texture && dot(along, along) > 1e-12) {
        along = normalize(along);
        vec3 turned = read_texture(detail.normal, at).xyz * 2.0 - 1.0;
        turned.xy *= detail.normal_scale;
        normal = unit_or_up(turned.x * along +
                            turned.y * tangent.w * cross(normal, along) + turned.z * normal);
    }
    return s;
}
