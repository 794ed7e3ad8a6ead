// Real spherical harmonics of order 0 to 2.
#ifndef HARMONICS_GLSL
#define HARMONICS_GLSL

float harmonic(int which, vec3 d) {
    switch (which) {
    case 0: return 0.282095;
    case 1: return 0.488603 * d.y;
    case 2: return 0.488603 * d.z;
    case 3: return 0.488603 * d.x;
    case 4: return 1.092548 * d.x * d.y;
    case 5: return 1.092548 * d.y * d.z;
    case 6: return 0.315392 * (3.0 * d.z * d.z - 1.0);
    case 7: return 1.092548 * d.x * d.z;
    default: return 0.546274 * (d.x * d.x - d.y * d.y);
    }
}

/// What the lobe of the cosine makes of a harmonic: pi, 2 pi / 3 and pi / 4.
float cosine_lobe(int which) {
    return which == 0 ? 3.14159265 : which < 4 ? 2.09439510 : 0.78539816;
}

#endif
