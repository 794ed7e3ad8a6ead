// Guards against what GLSL leaves undefined. Comparisons with NaN are false, so every function here
// is written such that NaN takes the branch that gives a number.
#ifndef SANITISE_GLSL
#define SANITISE_GLSL

const float half_max = 65504.0;

/// Light as half floats can hold it: NaN and negative values become 0, +Inf becomes 65504.
float sanitise(float v) {
    return v > 0.0 ? min(v, half_max) : 0.0;
}
vec3 sanitise(vec3 v) {
    return vec3(sanitise(v.r), sanitise(v.g), sanitise(v.b));
}

/// Within 0..1; NaN becomes 0.
float saturate(float v) {
    return v > 0.0 ? min(v, 1.0) : 0.0;
}
vec3 saturate(vec3 v) {
    return vec3(saturate(v.r), saturate(v.g), saturate(v.b));
}

/// The nearest value that a half float holds, ties to even. Drivers may truncate when they store to a
/// half-float image, which darkens with every pass; what is rounded here stores exactly.
float round_to_half(float v) {
    if (abs(v) < 0.00006103515625) { // denormals, whole multiples of 2^-24
        return roundEven(v * 16777216.0) / 16777216.0;
    }
    uint bits = floatBitsToUint(v);
    bits += 0xFFFu + (bits >> 13 & 1u);
    return uintBitsToFloat(bits & ~0x1FFFu);
}
vec3 round_to_half(vec3 v) {
    return vec3(round_to_half(v.r), round_to_half(v.g), round_to_half(v.b));
}

#endif
