// Specular antialiasing: normals that vary within a pixel make it rougher. Tokuyoshi and Kaplanyan
// 2019, "Improved geometric specular antialiasing", the isotropic form for deferred shading: a
// pixel's filter has the variance 1 / (2 pi), and alpha^2 grows by at most 0.18.
// preview/reference/ggx.h has the same in double.
#ifndef NORMAL_FILTER_GLSL
#define NORMAL_FILTER_GLSL

const float most_added = 0.18;

/// What is added to alpha^2 for a unit normal that changes by these to the pixels beside.
float added_by(vec3 dx, vec3 dy) {
    return min(0.318309886 * (dot(dx, dx) + dot(dy, dy)), most_added);
}

float filtered_roughness(float roughness, float added) {
    float alpha = roughness * roughness;
    return added > 0.0 ? sqrt(sqrt(min(alpha * alpha + added, 1.0))) : roughness;
}

// Beside the number of a material, in the eight bits above it: as its square root, so that small
// ones keep their digits.
const uint material_bits = 24u;

uint pack_added(float added) {
    return uint(sqrt(added / most_added) * 255.0 + 0.5) << material_bits;
}

float unpack_added(uint word) {
    float root = float(word >> material_bits) / 255.0;
    return root * root * most_added;
}

uint material_number(uint word) {
    return (word & (1u << material_bits) - 1u) - 1u;
}

#endif
