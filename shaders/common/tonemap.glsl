// The tone maps that mix channels, formula for formula those of preview/finish/tonemaps.cpp, which
// has the sources. Linear light of 0..65504 in, display-encoded 0..1 out. What treats the channels
// apart is read from its table (common/tone_curve.glsl).
#include "common/srgb.glsl"

vec3 aces_hill(vec3 c) {
    const mat3 into = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566,
                           0.83777);
    const mat3 out_of = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367,
                             -0.00605, 1.07602);
    vec3 v = into * c;
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return srgb_encode(clamp(out_of * v, 0.0, 1.0));
}

vec3 agx(vec3 c) {
    const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                            0.0784335999999992, 0.878468636469772, 0.0784336, 0.0792237451477643,
                            0.0791661274605434, 0.879142973793104);
    const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                             -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                             -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
    const float low = -12.47393, high = 4.026069;
    vec3 x = clamp((log2(max(inset * c, 1e-10)) - low) / (high - low), 0.0, 1.0);
    vec3 d = x - 10.0 / 16.5;
    vec3 m = abs(d);
    bvec3 above = greaterThan(d, vec3(0.0));
    vec3 bend =
        pow(1.0 + mix(vec3(59.507875), 69.86278913545539 * sqrt(sqrt(m)), above) * m * m * m,
            mix(vec3(-1.0 / 3.0), vec3(-4.0 / 13.0), above));
    return clamp(outset * (0.5 + 2.0 * d * bend), 0.0, 1.0);
}

vec3 khronos_neutral(vec3 c) {
    const float f90 = 0.04, start = 0.8 - f90, desaturation = 0.15;
    float least = min(c.r, min(c.g, c.b));
    c -= least < 2.0 * f90 ? least - least * least / (4.0 * f90) : f90;
    float peak = max(c.r, max(c.g, c.b));
    if (peak > start) {
        const float d = 1.0 - start;
        float new_peak = 1.0 - d * d / (peak + d - start);
        float grey = 1.0 - 1.0 / (desaturation * (peak - new_peak) + 1.0);
        c = mix(c * (new_peak / peak), vec3(new_peak), grey);
    }
    return srgb_encode(clamp(c, 0.0, 1.0));
}
