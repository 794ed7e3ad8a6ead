// IEC 61966-2-1.
#ifndef SRGB_GLSL
#define SRGB_GLSL

vec3 srgb_encode(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055,
               greaterThan(c, vec3(0.0031308)));
}

vec3 srgb_decode(vec3 v) {
    vec3 high = pow((max(v, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4));
    return mix(high, v / 12.92, lessThanEqual(v, vec3(0.04045)));
}

#endif
