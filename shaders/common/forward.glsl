// Lights a surface as it is drawn. With `blends` it goes over what stands behind it, by as much as
// it covers, and is hidden by what `depths` has in front of it.
#include "common/environment.glsl"
#include "common/scene.glsl"
#include "common/normal_filter.glsl"
layout(constant_id = 12) const bool filters_normals = false;
layout(constant_id = 13) const bool blends = false;
layout(binding = 2) uniform Views { View view; };
#ifdef HAS_DETAIL
#define DETAIL_BINDING 5
#include "common/detail_surface.glsl"
layout(std430, binding = 4) readonly buffer Materials { Material materials[]; };
layout(location = 2) in vec4 uv;
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 tangent;
#define FORWARD_BINDING 8
#else
layout(std430, binding = 3) readonly buffer Materials { Material materials[]; };
#define FORWARD_BINDING 4
#endif
layout(location = 0) in vec3 normal;
layout(location = 1) flat in uint material;
layout(location = 0) out vec4 out_light;
layout(binding = FORWARD_BINDING) uniform Environments { Environment environment; };
layout(std430, binding = FORWARD_BINDING + 1) readonly buffer Lights { Light lights[]; };
layout(binding = FORWARD_BINDING + 2) uniform sampler2DArray shadow_maps;
layout(binding = FORWARD_BINDING + 3) uniform sampler2D depths;
#define SURROUNDINGS_BINDING (FORWARD_BINDING + 4)
layout(push_constant) uniform Push {
    uint light_count;
    uint width, height;
};
#include "common/lit_surface.glsl"
#include "common/seen.glsl"
#include "common/sanitise.glsl"

void main() {
    vec3 ray = ray_at(view, gl_FragCoord.xy, vec2(width, height));
    vec3 position = view.position_near.xyz + ray * z_of(view, gl_FragCoord.z);
    vec3 shading = unit_or_up(normal);
    float added = filters_normals ? added_by(dFdx(shading), dFdy(shading)) : 0.0;
    vec3 face = shading;
    float coverage = 1.0;
#ifdef HAS_DETAIL
    vec3 found = cross(dFdx(position), dFdy(position));
    float squared = dot(found, found);
    Footprint at = Footprint(uv, dFdx(uv), dFdy(uv));
    Surface surface =
        surface_of(materials[material], material, at, color, tangent, shading, coverage);
    float least_coverage = material_details[material].least_coverage;
    if (least_coverage > 0.0 && coverage < least_coverage) {
        discard;
    }
    face = squared > 0.0 ? found * inversesqrt(squared) : shading;
    face = dot(face, shading) < 0.0 ? -face : face;
#else
    Material numbers = materials[material];
    Surface surface = Surface(numbers.albedo_roughness.rgb, numbers.albedo_roughness.a,
                              numbers.emission_metalness.a, 1.0, numbers.emission_metalness.rgb,
                              false);
#endif
    if (blends && gl_FragCoord.z > texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
    surface.roughness = filtered_roughness(surface.roughness, added);
    vec3 light = surface.is_unlit ? surface.emission
                                  : light_from(surface, position, shading, face, -normalize(ray),
                                               1.0);
    // What is blended is rounded once it has been.
    float share = blends ? clamp(coverage, 0.0, 1.0) : 1.0;
    out_light = vec4(blends ? light * share : round_to_half(light), share);
}
