// Lights the G-buffer: every point light with its shadow, the surroundings, emission, background.
// With HAS_DETAIL the G-buffer holds the surfaces themselves, else the numbers of their materials.
#include "common/scene.glsl"
#include "common/brdf.glsl"
#include "common/environment.glsl"
#include "common/surface.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const bool has_shadows = true;
layout(constant_id = 1) const bool has_environment = true;
layout(constant_id = 2) const bool has_spots = true;
layout(constant_id = 3) const bool has_suns = true;
layout(constant_id = 5) const bool has_occlusion = false;
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
layout(binding = 7) uniform sampler2DArrayShadow shadow_maps;
layout(binding = 8) uniform sampler2D occlusions;
layout(binding = 9) writeonly uniform image2D target;
layout(push_constant) uniform Push { uint light_count; };
#include "common/surroundings.glsl"

bool is_sun(Light light) {
    return has_suns && light.offset.y > 0.0;
}

/// 1 where the light reaches the point, 0 where not; 1 outside its frustum. Four bilinear
/// comparisons over 3.5 texels. The point is moved out along its normal by what a texel can be
/// wrong at its slant.
float lit(Light light, vec3 position, vec3 normal, float n_dot_l, float distance_to_light) {
    float slant = sqrt(max(1.0 - n_dot_l * n_dot_l, 0.0));
    float texel = light.intensity_texel.w * distance_to_light;
    vec4 clip = light.clip * vec4(position + normal * (texel * (0.5 + 2.0 * slant)), 1.0);
    if (is_sun(light)) {
        clip.z = min(clip.z, clip.w); // shadows go on behind the box of the casters
    }
    if (!(clip.w > 0.0) || any(greaterThan(abs(clip.xy), vec2(clip.w))) || clip.z > clip.w ||
        clip.z < 0.0) {
        return 1.0;
    }
    vec3 at = clip.xyz / clip.w;
    vec2 uv = at.xy * 0.5 + 0.5;
    vec2 reach = 0.75 / vec2(textureSize(shadow_maps, 0).xy);
    float sum = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        vec2 offset = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
        sum += texture(shadow_maps,
                       vec4(uv + offset * reach, light.position_layer.w, at.z));
    }
    return sum / 4.0;
}

Surface surface_at(ivec2 at) {
    uint word = texelFetch(material_numbers, at, 0).r;
#ifdef HAS_DETAIL
    return unpack_surface(word, texelFetch(albedos, at, 0).rgb, texelFetch(emissions, at, 0).rgb);
#else
    Material material = materials[word - 1u];
    return Surface(material.albedo_roughness.rgb, material.albedo_roughness.a,
                   material.emission_metalness.a, 1.0, material.emission_metalness.rgb, false);
#endif
}

/// What a spot's cone lets through: KHR_lights_punctual's own fall-off.
float cone(Light light, vec3 direction) {
    float share = clamp(dot(light.axis_scale.xyz, -direction) * light.axis_scale.w + light.offset.x,
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
    vec2 screen = (vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0;
    vec3 ray = view.forward.xyz + screen.x * view.right.xyz + screen.y * view.up.xyz;
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
    vec3 position = view.position_near.xyz + ray * (view.position_near.w / (1.0 - depth));
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

    vec3 radiance = surface.emission;
    for (uint index = 0; index < light_count; ++index) {
        Light light = lights[index];
        vec3 towards = light.position_layer.xyz - (is_sun(light) ? vec3(0.0) : position);
        // A light that touches the surface is held at a millimetre.
        float squared = max(dot(towards, towards), 1e-6);
        float distance_to_light = sqrt(squared);
        vec3 direction = towards / distance_to_light;
        float n_dot_l = dot(normal, direction);
        if (!(n_dot_l > 0.0)) {
            continue;
        }
        if (has_spots) {
            float share = cone(light, direction);
            if (share <= 0.0) {
                continue;
            }
            squared /= share;
        }
        vec3 shaded = shade(normal, to_eye, direction, albedo, roughness, metalness);
        if (has_shadows && light.position_layer.w >= 0.0) {
            shaded *= lit(light, position, normal, n_dot_l, distance_to_light);
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
