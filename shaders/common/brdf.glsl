// The surface model of preview/reference/ggx.h; its comment has the sources.
#ifndef BRDF_GLSL
#define BRDF_GLSL

const float pi = 3.14159265358979;
const float least_roughness = 0.045;

/// n.h^2 (alpha^2 - 1) + 1 of unit vectors; 1 from behind. Where a smooth surface's highlight is, n.h
/// is so near to 1 that floats of this form have lost their digits; the angle's sine keeps them.
float ggx_width_squared(vec3 normal, vec3 halfway, float alpha) {
    float n_dot_h = dot(normal, halfway);
    vec3 sine = cross(normal, halfway);
    float a = alpha * n_dot_h;
    return n_dot_h > 0.0 ? min(dot(sine, sine) + a * a, 1.0) : 1.0;
}

float ggx_distribution(float width_squared, float alpha) {
    return alpha * alpha / (pi * width_squared * width_squared);
}

float smith_visibility(float n_dot_l, float n_dot_v, float alpha) {
    float a2 = alpha * alpha;
    float l = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - a2) + a2);
    float v = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - a2) + a2);
    return 0.5 / max(l + v, 1e-9);
}

/// Of the model without n.l.
struct Lobes {
    vec3 diffuse, specular;
    float sharpness; // from 1 / alpha, where the half vector is the normal, to 1 across it
};

Lobes lobes_of(vec3 normal, vec3 view, vec3 light, vec3 albedo, float roughness, float metalness) {
    float n_dot_l = max(dot(normal, light), 0.0);
    float n_dot_v = max(dot(normal, view), 1e-4);
    vec3 sum = view + light;
    float squared = dot(sum, sum);
    vec3 halfway = squared > 1e-18 ? sum * inversesqrt(squared) : normal;
    float v_dot_h = clamp(dot(view, halfway), 0.0, 1.0);
    float alpha = max(roughness, least_roughness);
    alpha *= alpha;
    float width_squared = ggx_width_squared(normal, halfway, alpha);
    float lobe =
        ggx_distribution(width_squared, alpha) * smith_visibility(n_dot_l, n_dot_v, alpha);
    float grazing = 1.0 - v_dot_h;
    float grazing2 = grazing * grazing;
    vec3 f0 = mix(vec3(0.04), albedo, metalness);
    vec3 fresnel = f0 + (1.0 - f0) * (grazing2 * grazing2 * grazing);
    return Lobes((1.0 - fresnel) * (1.0 - metalness) * albedo / pi, fresnel * lobe,
                 inversesqrt(width_squared));
}

/// Radiance towards `view` per unit of irradiance at normal incidence from `light`.
vec3 shade(vec3 normal, vec3 view, vec3 light, vec3 albedo, float roughness, float metalness) {
    float n_dot_l = dot(normal, light);
    if (!(n_dot_l > 0.0)) {
        return vec3(0.0);
    }
    Lobes lobes = lobes_of(normal, view, light, albedo, roughness, metalness);
    return (lobes.diffuse + lobes.specular) * n_dot_l;
}

/// What a surface mirrors of its surroundings, integrated over the lobe: scale and bias of f0.
/// Karis 2014, "Physically based shading on mobile".
vec3 environment_reflectance(vec3 f0, float roughness, float n_dot_v) {
    const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022);
    const vec4 c1 = vec4(1.0, 0.0425, 1.04, -0.04);
    vec4 r = roughness * c0 + c1;
    float a = min(r.x * r.x, exp2(-9.28 * n_dot_v)) * r.x + r.y;
    vec2 fit = vec2(-1.04, 1.04) * a + r.zw;
    return max(f0 * fit.x + fit.y, 0.0); // the fit is a little below nothing for the darkest f0
}

#endif
