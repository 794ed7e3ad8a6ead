// Light as an image keeps it, rounded before it is stored: drivers may cut off. After
// common/sanitise.glsl.
#ifndef STORED_GLSL
#define STORED_GLSL

// What the work images of bloom are (preview/passes/bloom.cpp).
const int stored_half = 0, stored_float = 1, stored_packed = 2;

/// The nearest value with 5 bits of exponent and so few bits of mantissa, `cut` fewer than a float.
/// Denormals are whole multiples of 2^-14 over those bits.
float round_to_packed(float v, int cut) {
    if (v < 0.00006103515625) {
        float steps = exp2(float(14 + 23 - cut));
        return roundEven(v * steps) / steps;
    }
    uint bits = floatBitsToUint(v), half_step = 1u << (cut - 1);
    bits += half_step - 1u + (bits >> cut & 1u);
    return uintBitsToFloat(bits >> cut << cut);
}

/// `light` is not negative. 11 and 10 bits keep 6 and 5 of mantissa, up to 65024 and 64512.
vec3 as_stored(vec3 light, int kind) {
    light = min(light, half_max);
    if (kind == stored_float) {
        return light;
    }
    if (kind == stored_packed) {
        light = min(light, vec3(65024.0, 65024.0, 64512.0));
        return vec3(round_to_packed(light.r, 17), round_to_packed(light.g, 17),
                    round_to_packed(light.b, 18));
    }
    return round_to_half(light);
}

#endif
