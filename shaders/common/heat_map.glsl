// The colours of a heat map, and its scale.
#include "common/sanitise.glsl"

/// Black, blue, magenta, orange, yellow, white over 0..1: brighter is more, in grey too.
vec3 heat(float share) {
    const vec3 stops[6] = vec3[6](vec3(0.0, 0.0, 0.02), vec3(0.13, 0.08, 0.46),
                                  vec3(0.60, 0.13, 0.46), vec3(0.93, 0.41, 0.20),
                                  vec3(0.99, 0.78, 0.24), vec3(1.0, 1.0, 0.92));
    float x = saturate(share) * 5.0;
    int i = min(int(x), 4);
    return mix(stops[i], stops[i + 1], x - float(i));
}

// The figures 0 to 9, three wide and five high, rows from the top in bits 14 to 0.
const uint figures[10] = uint[10](31599u, 11415u, 29671u, 29647u, 23497u, 31183u, 31215u, 29257u,
                                  31727u, 31695u);

/// Whether the texel `at`, relative to the upper right corner of a number, is part of it.
bool in_number(ivec2 at, int number, int dot_size) {
    ivec2 cell = ivec2(floor(vec2(at) / float(dot_size)));
    if (cell.y < 0 || cell.y > 4 || cell.x >= 0)
        return false;
    int place = (-cell.x - 1) / 4, column = 3 - (-cell.x - 1) % 4 - 1;
    int digit = place == 0 ? number % 10 : number / 10;
    if (column < 0 || place > 1 || (place == 1 && number < 10))
        return false;
    return (figures[digit] >> (14 - cell.y * 3 - column) & 1u) != 0u;
}

/// Draws the scale of a heat map into the lower left corner: a bar with the figures 0, 1/4, 1/2, 3/4
/// and all of `scale`, which is divisible by 4.
vec3 with_scale(vec3 color, ivec2 at, ivec2 size, float scale) {
    int unit = max(size.y / 180, 1);
    ivec2 bar = ivec2(64 * unit, 5 * unit);
    ivec2 from = ivec2(8 * unit, size.y - 16 * unit);
    ivec2 p = at - from;
    ivec2 panel_low = ivec2(-5 * unit, -4 * unit), panel_high = bar + ivec2(6, 10) * unit;
    if (any(lessThan(p, panel_low)) || any(greaterThanEqual(p, panel_high)))
        return color;
    if (all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, bar)))
        return heat((float(p.x) + 0.5) / float(bar.x));
    for (int i = 0; i <= 4; ++i) {
        int number = int(scale) * i / 4;
        int width = (number < 10 ? 3 : 7) * unit;
        ivec2 corner = ivec2(bar.x * i / 4 + (width + unit) / 2, bar.y + 2 * unit);
        if (in_number(p - corner, number, unit))
            return vec3(1.0);
    }
    return vec3(0.04);
}
