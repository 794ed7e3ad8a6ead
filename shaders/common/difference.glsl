// CIEDE2000 between two sRGB-encoded colours, as lutlib/color/difference.h has it (Sharma, Wu, Dalal
// 2005), and how a picture of it looks.
#include "common/sanitise.glsl"
#include "common/srgb.glsl"

vec3 lab_of(vec3 srgb) {
    const mat3 to_xyz = mat3(0.4123908, 0.2126390, 0.0193308, 0.3575843, 0.7151687, 0.1191948,
                             0.1804808, 0.0721923, 0.9505322);
    const vec3 white = vec3(0.9504559, 1.0, 1.0890578);
    vec3 t = to_xyz * srgb_decode(srgb) / white;
    const float e = 216.0 / 24389.0, k = 24389.0 / 27.0;
    vec3 f = mix(pow(max(t, vec3(e)), vec3(1.0 / 3.0)), (k * t + 16.0) / 116.0,
                 lessThanEqual(t, vec3(e)));
    return vec3(116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z));
}

float hue_of(float b, float a) {
    return a == 0.0 && b == 0.0 ? 0.0 : atan(b, a);
}

float seventh_share(float chroma) {
    float c7 = pow(max(chroma, 1e-6) / 25.0, 7.0);
    return sqrt(c7 / (c7 + 1.0));
}

float delta_e_2000(vec3 srgb_a, vec3 srgb_b) {
    const float pi = 3.14159265358979;
    vec3 p = lab_of(srgb_a), q = lab_of(srgb_b);
    float g = 1.5 - 0.5 * seventh_share(0.5 * (length(p.yz) + length(q.yz)));
    p.y *= g;
    q.y *= g;
    float cp = length(p.yz), cq = length(q.yz);
    float hp = hue_of(p.z, p.y), hq = hue_of(q.z, q.y);
    hp += hp < 0.0 ? 2.0 * pi : 0.0;
    hq += hq < 0.0 ? 2.0 * pi : 0.0;
    bool grey = cp * cq == 0.0;
    float turn = grey ? 0.0 : hq - hp;
    turn += turn > pi ? -2.0 * pi : turn < -pi ? 2.0 * pi : 0.0;
    float mean_h = 0.5 * (hp + hq);
    if (grey)
        mean_h = hp + hq;
    else if (abs(hp - hq) > pi)
        mean_h += mean_h < pi ? pi : -pi;
    float dl = q.x - p.x, dc = cq - cp, dh = 2.0 * sqrt(cp * cq) * sin(0.5 * turn);
    float ml = 0.5 * (p.x + q.x), mc = 0.5 * (cp + cq);
    float t = 1.0 - 0.17 * cos(mean_h - pi / 6.0) + 0.24 * cos(2.0 * mean_h) +
              0.32 * cos(3.0 * mean_h + pi / 30.0) - 0.20 * cos(4.0 * mean_h - 0.35 * pi);
    float from_middle = (ml - 50.0) * (ml - 50.0);
    float sl = 1.0 + 0.015 * from_middle / sqrt(20.0 + from_middle);
    float sc = 1.0 + 0.045 * mc, sh = 1.0 + 0.015 * mc * t;
    float blue = (mean_h * 180.0 / pi - 275.0) / 25.0;
    float rotation = -sin(pi / 3.0 * exp(-blue * blue)) * 2.0 * seventh_share(mc);
    float l = dl / sl, c = dc / sc, h = dh / sh;
    return sqrt(max(l * l + c * c + h * h + rotation * c * h, 0.0));
}

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
