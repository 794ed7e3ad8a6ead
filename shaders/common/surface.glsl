// The surfaces of scenes with textures as the g-buffer holds them: `word` of the material image has
// roughness, metalness and occlusion, ten bits each, and whether the surface is unlit; colours have
// images of their own.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

struct Surface {
    vec3 albedo;
    float roughness;
    float metalness;
    float occlusion;
    vec3 emission;
    bool is_unlit;
};

uint pack_surface(Surface s) {
    uvec3 steps = uvec3(clamp(vec3(s.roughness, s.metalness, s.occlusion), 0.0, 1.0) * 1023.0 + 0.5);
    return 1u << 31 | (s.is_unlit ? 1u << 30 : 0u) | steps.x << 20 | steps.y << 10 | steps.z;
}

bool is_unlit(uint word) {
    return (word & 1u << 30) != 0u;
}

Surface unpack_surface(uint word, vec3 albedo, vec3 emission) {
    return Surface(albedo, float(word >> 20 & 1023u) / 1023.0, float(word >> 10 & 1023u) / 1023.0,
                   float(word & 1023u) / 1023.0, emission, is_unlit(word));
}

#endif
