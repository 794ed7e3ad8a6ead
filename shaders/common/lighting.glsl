// Lights the G-buffer: every point light with its shadow, the surroundings, emission, background.
// With HAS_DETAIL the G-buffer holds the surfaces themselves, else the numbers of their materials.
#include "common/scene.glsl"
#include "common/brdf.glsl"
#include "common/environment.glsl"
#include "common/surface.glsl"
#include "common/normal_filter.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const bool has_shadows = true;
layout(constant_id = 1) const bool has_environment = true;
layout(constant_id = 2) const bool has_spots = true;
layout(constant_id = 3) const bool has_suns = true;
layout(constant_id = 5) const bool has_occlusion = false;
layout(constant_id = 6) const bool has_areas = false;
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
#include "common/surroundings.glsl"
#include "common/seen.glsl"

/// A sun has its direction in place of a position.
bool is_sun(Light light) {
    return has_suns && light.range.w > 0.0;
}
#include "common/shadow.glsl"
#include "common/area_light.glsl"

Surface surface_at(ivec2 at) {
    uint word = texelFetch(material_numbers, at, 0).r;
#ifdef HAS_DETAIL
    return unpack_surface(word, texelFetch(albedos, at, 0).rgb, texelFetch(emissions, at, 0).rgb);
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

/// What a spot's cone lets through: KHR_lights_punctual's own fall-off.
float cone(Light light, vec3 direction) {
    float share = clamp(dot(light.axis_scale.xyz, -direction) * light.axis_scale.w + light.range.x,
                        0.0, 1.0);
    return share * share;
}

/// Of what a surface mirrors, from what is left of its diffuse surroundings: Lagarde and de Rousiers
/// 2014, "Moving Frostbite to physically based rendering", with alpha for their roughness.
float mirrored_occlusion(float occlusion, float n_dot_v, float roughness) {
    float sharpness = exp2(-16.0 * roughness * roughness - 1.0);
    return clamp(pow(n_dot_v + occlusion, sharpness) - 1.0 + occlusion, 0.0, 1.0);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    vec3 ray = ray_at(view, vec2(at) + 0.5, vec2(size));
    float depth = texelFetch(depths, at, 0).r;
    if (depth >= 1.0) {
        vec3 background = vec3(0.0);
        if (has_environment) {
            float pixel = 2.0 * length(view.up.xyz) / float(size.y);
            background = surroundings_kind == kind_gradient
                             ? environment_radiance(environment, normalize(ray), 0.0)
                             : surroundings_behind(normalize(ray), pixel);
        }
        imageStore(target, at, vec4(background, 1.0));
        return;
    }
    vec3 position = view.position_near.xyz + ray * z_of(view, depth);
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    Surface surface = surface_at(at);
    if (surface.is_unlit) {
        imageStore(target, at, vec4(surface.emission, 1.0));
        return;
    }
    vec3 albedo = surface.albedo;
    float roughness = surface.roughness;
    float metalness = surface.metalness;
    vec3 to_eye = -normalize(ray);

#ifdef HAS_DETAIL
    vec3 face = has_shadows ? face_normal(at, size, depth, normal) : normal;
#else
    vec3 face = normal;
#endif
    vec3 radiance = surface.emission;
    for (uint index = 0; index < light_count; ++index) {
        Light light = lights[index];
        vec3 towards = light.position_layer.xyz - (is_sun(light) ? vec3(0.0) : position);
        // A light that touches the surface is held at a millimetre.
        float squared = max(dot(towards, towards), 1e-6);
        float distance_to_light = sqrt(squared);
        vec3 direction = towards / distance_to_light;
        bool is_area =
            has_areas && (light.extent_shape.w > 0.0 || light.up_thickness.w > 0.0);
        if (!is_area && !(dot(normal, direction) > 0.0)) {
            continue;
        }
        if (has_spots) {
            float share = cone(light, direction);
            if (share <= 0.0) {
                continue;
            }
            squared /= share;
        }
        vec3 shaded;
        if (is_area) {
            shaded = shade_area(light, position, normal, to_eye, albedo, roughness, metalness) *
                     distance_to_light * distance_to_light;
        } else {
            shaded = shade(normal, to_eye, direction, albedo, roughness, metalness);
        }
        if (has_shadows && light.position_layer.w >= 0.0) {
            shaded *= lit(light, position, face);
        }
        radiance += shaded * light.intensity_texel.rgb / squared;
    }
    if (has_environment) {
        float n_dot_v = clamp(dot(normal, to_eye), 0.0, 1.0);
        float seen_mirrored = surface.occlusion, seen = surface.occlusion;
        if (has_occlusion) {
            float occlusion = texelFetch(occlusions, at, 0).r;
            seen *= occlusion;
            seen_mirrored *= mirrored_occlusion(occlusion, n_dot_v, roughness);
        }
        if (has_map()) {
            radiance += surroundings_light(normal, to_eye, albedo, roughness, metalness, seen,
                                           seen_mirrored);
        } else {
            vec3 f0 = mix(vec3(0.04), albedo, metalness);
            vec3 mirrored = environment_reflectance(f0, roughness, n_dot_v);
            radiance += seen_mirrored * mirrored *
                        environment_radiance(environment, reflect(-to_eye, normal), roughness);
            radiance += seen * (1.0 - mirrored) * (1.0 - metalness) * albedo / pi *
                        environment_irradiance(environment, normal);
        }
    }
    imageStore(target, at, vec4(radiance, 1.0));
}
