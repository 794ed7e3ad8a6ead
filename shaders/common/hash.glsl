// Random numbers from whole numbers, the same on every device. preview/reference/hash.h is the same
// on the CPU.
#ifndef HASH_GLSL
#define HASH_GLSL

/// PCG3D: Jarzynski and Olano 2020, "Hash functions for GPU rendering".
uvec3 pcg3d(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// Of 24 bits, 0 and more, below 1.
vec3 unit_of(uvec3 bits) {
    return vec3(bits >> 8u) / 16777216.0;
}

/// Each the sum of two even numbers: within -1..1, of variance 1/6.
vec3 triangular_of(uvec3 bits) {
    return vec3((bits & 0xFFFFu) + (bits >> 16u)) / 65536.0 - 1.0;
}

#endif
