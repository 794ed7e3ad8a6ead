// Lights the G-buffer: every point light with its shadow, the surroundings, emission, background. What
// light cannot change (the sky, unlit surfaces) is done with before any light is looked at.
// With HAS_DETAIL the G-buffer holds the surfaces themselves, else the numbers of their materials.
#include "common/environment.glsl"
#include "common/scene.glsl"
#include "common/normal_filter.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform Views { View view; };
layout(binding = 1) uniform Environments { Environment environment; };
layout(std430, binding = 2) readonly buffer Lights { Light lights[]; };
layout(binding = 3) uniform sampler2D depths;
layout(binding = 4) uniform usampler2D normals;
layout(binding = 5) uniform usampler2D material_numbers;
#ifdef HAS_DETAIL
layout(binding = 6) uniform sampler2D albedos;
layout(binding = 10) uniform sampler2D emissions;
#define SURROUNDINGS_BINDING 11
#else
#define SURROUNDINGS_BINDING 10
layout(std430, binding = 6) readonly buffer Materials { Material materials[]; };
#endif
layout(binding = 7) uniform sampler2DArray shadow_maps;
layout(binding = 8) uniform sampler2D occlusions;
layout(binding = 9) writeonly uniform image2D target;
layout(push_constant) uniform Push { uint light_count; };
layout(constant_id = 12) const bool has_lists = false;
layout(constant_id = 13) const bool has_own_light = true; // else emission is black everywhere
layout(constant_id = 14) const bool counts_lights = false; // in place of their light
#include "common/light_lists.glsl"
#define SHINING_COUNT (has_lists ? listed_count : light_count)
#define SHINING(i) (has_lists ? listed[i] : i)
#include "common/lit_surface.glsl"
#include "common/background.glsl"
#include "common/seen.glsl"
#include "common/sanitise.glsl"

Surface surface_at(ivec2 at) {
    uint word = texelFetch(material_numbers, at, 0).r;
#ifdef HAS_DETAIL
    vec3 emission = has_own_light ? texelFetch(emissions, at, 0).rgb : vec3(0.0);
    return unpack_surface(word, texelFetch(albedos, at, 0).rgb, emission);
#else
    Material material = materials[material_number(word)];
    return Surface(material.albedo_roughness.rgb,
                   filtered_roughness(material.albedo_roughness.a, unpack_added(word)),
                   material.emission_metalness.a, 1.0, material.emission_metalness.rgb, false);
#endif
}

#ifdef HAS_DETAIL
/// Of the geometry, where textures have turned the shading's normal: from what the picture shows
/// beside it, on the side of each axis that is nearer in depth.
vec3 face_normal(ivec2 at, ivec2 size, float depth, vec3 normal) {
    vec3 along[2];
    vec3 position = ray_at(view, vec2(at) + 0.5, vec2(size)) * z_of(view, depth);
    for (int axis = 0; axis < 2; ++axis) {
        float least = 2.0;
        along[axis] = vec3(0.0);
        for (int side = -1; side <= 1; side += 2) {
            ivec2 there = at + (axis == 0 ? ivec2(side, 0) : ivec2(0, side));
            if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, size))) {
                continue;
            }
            float beside = texelFetch(depths, there, 0).r;
            if (beside < 1.0 && abs(beside - depth) < least) {
                least = abs(beside - depth);
                along[axis] = (ray_at(view, vec2(there) + 0.5, vec2(size)) * z_of(view, beside) -
                               position) * float(side);
            }
        }
    }
    vec3 found = cross(along[0], along[1]);
    float squared = dot(found, found);
    if (!(squared > 0.0)) {
        return normal;
    }
    found *= inversesqrt(squared);
    return dot(found, normal) < 0.0 ? -found : found;
}
#endif

/// Whether light changes the surface there.
bool is_lit_at(ivec2 at) {
#ifdef HAS_DETAIL
    return takes_light && !is_unlit(texelFetch(material_numbers, at, 0).r);
#else
    return takes_light;
#endif
}

vec3 own_light_at(ivec2 at) {
#ifdef HAS_DETAIL
    return has_own_light ? texelFetch(emissions, at, 0).rgb : vec3(0.0);
#else
    uint word = texelFetch(material_numbers, at, 0).r;
    return has_own_light ? materials[material_number(word)].emission_metalness.rgb : vec3(0.0);
#endif
}

vec3 light_at(ivec2 at, ivec2 size) {
    vec3 ray = ray_at(view, vec2(at) + 0.5, vec2(size));
    float depth = texelFetch(depths, at, 0).r;
    if (depth >= 1.0) {
        return counts_lights ? vec3(0.0) : background_at(normalize(ray), float(size.y));
    }
    if (!is_lit_at(at)) {
        return counts_lights ? vec3(0.0) : own_light_at(at);
    }
    if (counts_lights) {
        return vec3(float(SHINING_COUNT));
    }
    vec3 position = view.position_near.xyz + ray * z_of(view, depth);
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    Surface surface = surface_at(at);
    vec3 to_eye = -normalize(ray);
#ifdef HAS_DETAIL
    vec3 face = has_shadows ? face_normal(at, size, depth, normal) : normal;
#else
    vec3 face = normal;
#endif
    float occlusion = has_occlusion ? texelFetch(occlusions, at, 0).r : 1.0;
    return light_from(surface, position, normal, face, to_eye, occlusion);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    bool is_inside = all(lessThan(at, size));
    if (has_lists) {
        float depth = is_inside ? texelFetch(depths, at, 0).r : 1.0;
        list_lights(depth < 1.0 && is_lit_at(at), view.position_near.xyz + z_of(view, depth) *
                                     ray_at(view, vec2(at) + 0.5, vec2(size)));
    }
    if (is_inside) {
        imageStore(target, at, vec4(round_to_half(light_at(at, size)), 1.0));
    }
}
