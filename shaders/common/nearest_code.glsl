// Vulkan lets a device choose how it rounds what is stored in 8 bits; errors of 0.55 of a code are seen.
vec3 nearest_code(vec3 c) {
    return floor(c * 255.0 + 0.5) * (1.0 / 255.0);
}
