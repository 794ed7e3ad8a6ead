// All of a surface at a point. After common/scene.glsl; who includes this defines DETAIL_BINDING.
#include "common/detail.glsl"
#include "common/surface.glsl"

/// What a material's textures say; 1 where it has none.
struct TextureValues {
    vec4 base, surface, normal, occlusion, emission;
};

/// One body of code in a loop over those that there are: drivers that run on a CPU go through every
/// branch, taken or not.
TextureValues texels_of(uint material, Footprint at) {
    uint left = 0u;
    for (int i = 0; i < 5; ++i) {
        left |= material_details[material].uses[i].number != no_texture ? 1u << i : 0u;
    }
    vec4 one = vec4(1.0);
    TextureValues values = TextureValues(one, one, one, one, one);
    while (left != 0u) {
        int which = findLSB(left);
        left &= left - 1u;
        vec4 texel = read_texture(material_details[material].uses[which], at);
        values.base = which == base_use ? texel : values.base;
        values.surface = which == surface_use ? texel : values.surface;
        values.normal = which == normal_use ? texel : values.normal;
        values.occlusion = which == occlusion_use ? texel : values.occlusion;
        values.emission = which == emission_use ? texel : values.emission;
    }
    return values;
}

/// `tangent.w`: its side, as VertexDetail has it. Turns the normal; tells how far the surface
/// covers what lies behind.
Surface surface_of(Material material, uint number, Footprint at, vec4 color, vec4 tangent,
                   inout vec3 normal, out float coverage) {
    TextureValues texels = texels_of(number, at);
    vec4 base = vec4(material.albedo_roughness.rgb, material_details[number].coverage) * color *
                texels.base;
    coverage = base.a;
    Surface s;
    s.albedo = clamp(base.rgb, 0.0, 1.0);
    s.is_unlit = material_details[number].is_unlit.x != 0u;
    s.roughness = material.albedo_roughness.a;
    s.metalness = material.emission_metalness.a;
    s.occlusion = 1.0;
    if (s.is_unlit) {
        s.emission = s.albedo;
        return s;
    }
    s.roughness *= texels.surface.g;
    s.metalness *= texels.surface.b;
    s.occlusion += material_details[number].occlusion_strength * (texels.occlusion.r - 1.0);
    s.emission = material.emission_metalness.rgb * texels.emission.rgb;
    vec3 along = tangent.xyz - normal * dot(normal, tangent.xyz);
    bool has_bumps = material_details[number].uses[normal_use].number != no_texture;
    if (has_bumps && dot(along, along) > 1e-12) {
        along = normalize(along);
        vec3 turned = texels.normal.xyz * 2.0 - 1.0;
        turned.xy *= material_details[number].normal_scale;
        normal = unit_or_up(turned.x * along +
                            turned.y * tangent.w * cross(normal, along) + turned.z * normal);
    }
    return s;
}
