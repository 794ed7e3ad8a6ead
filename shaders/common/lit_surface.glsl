// The light that leaves a surface for the eye. Who includes this has `view`, `environment`,
// `lights`, `light_count` and `shadow_maps`, and defines SURROUNDINGS_BINDING; after
// common/scene.glsl and common/environment.glsl. Who has a list of the lights that reach a place
// defines SHINING_COUNT and SHINING(i), their numbers.
#include "common/brdf.glsl"
#include "common/surface.glsl"
#include "common/lighting_constants.glsl"
#include "common/environment_light.glsl"
#include "common/surroundings.glsl"

#ifndef SHINING
#define SHINING_COUNT light_count
#define SHINING(i) i
#endif

/// A sun has its direction in place of a position.
bool is_sun(Light light) {
    return has_suns && light.range.w > 0.0;
}
#include "common/shadow.glsl"
#include "common/area_light.glsl"

/// What a spot's cone lets through: KHR_lights_punctual's own fall-off.
float cone(Light light, vec3 direction) {
    float share = clamp(dot(light.axis_scale.xyz, -direction) * light.axis_scale.w + light.range.x,
                        0.0, 1.0);
    return share * share;
}

/// What is left of a light that ends: KHR_lights_punctual's own fall-off.
float left_within_reach(Light light, float squared) {
    float part = squared * light.forward.w;
    return 1.0 - part * part;
}

/// Of what a surface mirrors, from what is left of its diffuse surroundings: Lagarde and de Rousiers
/// 2014, "Moving Frostbite to physically based rendering", with alpha for their roughness.
float mirrored_occlusion(float occlusion, float n_dot_v, float roughness) {
    float sharpness = exp2(-16.0 * roughness * roughness - 1.0);
    return clamp(pow(n_dot_v + occlusion, sharpness) - 1.0 + occlusion, 0.0, 1.0);
}

/// `face`: the geometry's normal. `occlusion`: what is left of the diffuse surroundings, where
/// has_occlusion.
vec3 light_from(Surface surface, vec3 position, vec3 normal, vec3 face, vec3 to_eye,
                float occlusion) {
    vec3 albedo = surface.albedo;
    float roughness = surface.roughness;
    float metalness = surface.metalness;
    vec3 radiance = surface.emission;
    uint count = SHINING_COUNT;
    for (uint index = 0; index < count; ++index) {
        Light light = lights[SHINING(index)];
        vec3 towards = light.position_layer.xyz - (is_sun(light) ? vec3(0.0) : position);
        // A light that touches the surface is held at a millimetre.
        float squared = max(dot(towards, towards), 1e-6);
        if (!(squared < 1e30)) {
            continue; // floats do not square its distance, and it lights nothing
        }
        float distance_to_light = sqrt(squared);
        float left = has_ends ? left_within_reach(light, squared) : 1.0;
        if (!(left > 0.0)) {
            continue;
        }
        vec3 direction = towards / distance_to_light;
        bool is_area =
            area_shapes != 0 && (light.extent_shape.w > 0.0 || light.up_thickness.w > 0.0);
        if (!is_area && !(dot(normal, direction) > 0.0)) {
            continue;
        }
        // All of a light stands behind the surface; the octagon for a ring is a little larger.
        if (is_area && !(dot(normal, towards) + 1.06 * length(light.extent_shape.xyz) +
                             light.up_thickness.w > 0.0)) {
            continue;
        }
        if (has_ends) {
            squared /= left;
        }
        if (has_spots) {
            float share = cone(light, direction);
            if (share <= 0.0) {
                continue;
            }
            squared /= share;
        }
        float reached =
            has_shadows && light.position_layer.w >= 0.0 ? lit(light, position, face) : 1.0;
        if (!(reached > 0.0)) {
            continue;
        }
        vec3 shaded;
        if (is_area) {
            shaded = shade_area(light, position, normal, to_eye, albedo, roughness, metalness) *
                     distance_to_light * distance_to_light;
        } else {
            shaded = shade(normal, to_eye, direction, albedo, roughness, metalness);
        }
        radiance += shaded * light.intensity_texel.rgb * (reached / squared);
    }
    if (has_environment) {
        float n_dot_v = clamp(dot(normal, to_eye), 0.0, 1.0);
        float seen_mirrored = surface.occlusion, seen = surface.occlusion;
        if (has_occlusion) {
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
                        environment_radiance(reflect(-to_eye, normal), roughness);
            radiance += seen * (1.0 - mirrored) * (1.0 - metalness) * albedo / pi *
                        environment_irradiance(normal);
        }
    }
    return radiance;
}
