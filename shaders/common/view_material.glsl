// A debug view of the surfaces that the material image holds. Who includes this defines
// shown_material(); where there is no surface the view is black.
#define VIEW_UNSIGNED
#include "common/scene.glsl"
#include "common/surface.glsl"
#include "common/normal_filter.glsl"
#include "common/view.glsl"
layout(constant_id = 1) const bool has_detail = false;
layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };
layout(binding = 3) uniform sampler2D albedos;
layout(binding = 4) uniform sampler2D emissions;

vec3 shown_material(Material material);

vec3 shown(uvec4 texel) {
    if (texel.r == 0u) {
        return vec3(0.0);
    }
    if (!has_detail) {
        Material material = materials[material_number(texel.r)];
        material.albedo_roughness.a =
            filtered_roughness(material.albedo_roughness.a, unpack_added(texel.r));
        return shown_material(material);
    }
    Surface s = unpack_surface(texel.r, texelFetch(albedos, shown_at, 0).rgb,
                               texelFetch(emissions, shown_at, 0).rgb);
    return shown_material(Material(vec4(s.albedo, s.roughness), vec4(s.emission, s.metalness)));
}
