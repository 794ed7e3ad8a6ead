// Surroundings of other kinds than the gradient of common/environment.glsl. Who includes this
// defines SURROUNDINGS_BINDING, the first of six bindings, and has pi.
#ifndef SURROUNDINGS_GLSL
#define SURROUNDINGS_GLSL
#include "common/harmonics.glsl"
#include "common/noise.glsl"
#include "common/sky.glsl"
#include "common/sphere.glsl"

const uint kind_gradient = 0u, kind_sky = 1u, kind_picture = 2u,
           kind_noise = 3u;
layout(constant_id = 4) const uint surroundings_kind = kind_gradient;

struct Surroundings {
    vec4 turn_scale; // cosine and sine of the turn about y, factor of all radiance, levels
    vec4 disc;       // radiance of the sun's disc; w: its angular radius
    vec4 noise;      // hue, value, scale, shift
    Sky sky;
};
layout(binding = SURROUNDINGS_BINDING) uniform SurroundingsBlocks { Surroundings surroundings; };
layout(std430, binding = SURROUNDINGS_BINDING + 1) readonly buffer Harmonics { vec4 harmonics[]; };
layout(binding = SURROUNDINGS_BINDING + 2) uniform sampler2D surroundings_levels;
layout(binding = SURROUNDINGS_BINDING + 3) uniform sampler2D surroundings_mirror;
layout(binding = SURROUNDINGS_BINDING + 4) uniform sampler2D surroundings_picture;
layout(binding = SURROUNDINGS_BINDING + 5) uniform sampler2D surroundings_reflectance;

bool has_map() {
    return surroundings_kind == kind_sky || surroundings_kind == kind_picture;
}

vec3 turned(vec3 direction) {
    vec2 turn = surroundings.turn_scale.xy;
    return vec3(turn.x * direction.x + turn.y * direction.z, direction.y,
                turn.x * direction.z - turn.y * direction.x);
}

/// From the stack of pictures `all`, that of number `level` of the height `height`; nothing of the
/// ones beside it.
vec3 sphere_texture(sampler2D all, vec2 uv, float level, float height) {
    float row = clamp(uv.y * height, 0.5, height - 0.5) + level * height;
    return textureLod(all, vec2(uv.x, row / float(textureSize(all, 0).y)), 0.0).rgb;
}

/// As a surface of that roughness mirrors them.
vec3 mirrored_surroundings(vec3 direction, float roughness) {
    vec3 d = turned(direction);
    vec2 uv = sphere_uv(d);
    float levels = surroundings.turn_scale.w;
    float height = float(textureSize(surroundings_levels, 0).y) / levels;
    float level = clamp(roughness, 0.0, 1.0) * levels - 1.0;
    float lower = max(floor(level), 0.0);
    vec3 rough = sphere_texture(surroundings_levels, uv, lower, height);
    vec3 other;
    if (level < 0.0) {
        other = surroundings_kind == kind_sky
                    ? sky_radiance(surroundings.sky, d)
                    : sphere_texture(surroundings_mirror, uv, 0.0,
                                     float(textureSize(surroundings_mirror, 0).y));
    } else {
        other = sphere_texture(surroundings_levels, uv, min(lower + 1.0, levels - 1.0), height);
    }
    return mix(rough, other, abs(level - lower)) * surroundings.turn_scale.z;
}

vec3 surroundings_irradiance(vec3 normal) {
    vec3 d = turned(normal);
    vec3 sum = vec3(0.0);
    for (int which = 0; which < 9; ++which) {
        sum += harmonics[which].rgb * harmonic(which, d);
    }
    return max(sum, vec3(0.0)) * surroundings.turn_scale.z;
}

/// What the eye sees of the surroundings themselves. `pixel` is the angle of a pixel.
vec3 surroundings_behind(vec3 direction, float pixel) {
    if (surroundings_kind == kind_noise) {
        return noise_background(surroundings.noise, direction);
    }
    vec3 d = turned(direction);
    if (surroundings_kind == kind_picture) {
        return sphere_texture(surroundings_picture, sphere_uv(d), 0.0,
                              float(textureSize(surroundings_picture, 0).y)) *
               surroundings.turn_scale.z;
    }
    vec3 sky = sky_radiance(surroundings.sky, d) * surroundings.turn_scale.z;
    // The chord is the angle for angles so small.
    float away = length(d - surroundings.sky.towards_sun.xyz);
    float covered = clamp((surroundings.disc.w - away) / pixel + 0.5, 0.0, 1.0);
    return sky + surroundings.disc.rgb * (covered * smoothstep(-0.002, 0.002, d.y));
}

/// What a surface reflects of the surroundings. With what its facets reflect more than once:
/// Fdez-Aguera 2019, "A multiple-scattering microfacet model for real-time image-based lighting".
/// `seen` of the diffuse surroundings and `seen_mirrored` of what it mirrors are not hidden.
vec3 surroundings_light(vec3 normal, vec3 to_eye, vec3 albedo, float roughness, float metalness,
                        float seen, float seen_mirrored) {
    vec2 node = clamp(vec2(dot(normal, to_eye), roughness), 0.0, 1.0);
    vec2 nodes = vec2(textureSize(surroundings_reflectance, 0));
    vec2 part =
        textureLod(surroundings_reflectance, (node * (nodes - 1.0) + 0.5) / nodes, 0.0).xy;
    vec3 f0 = mix(vec3(0.04), albedo, metalness);
    vec3 once = f0 * part.x + part.y;
    float missing = clamp(1.0 - part.x - part.y, 0.0, 1.0);
    vec3 mean = f0 + (1.0 - f0) / 21.0;
    vec3 more = missing * once * mean / (1.0 - mean * missing);
    vec3 diffuse = (1.0 - once - more) * (1.0 - metalness) * albedo;
    vec3 mirrored = mirrored_surroundings(reflect(-to_eye, normal), roughness);
    return seen_mirrored * once * mirrored +
           seen * (more + diffuse) / pi * surroundings_irradiance(normal);
}

#endif
