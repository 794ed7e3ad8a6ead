// CIEDE2000 between two sRGB-encoded colours, as lutlib/color/difference.h has it (Sharma, Wu,
// Dalal 2005).
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
    if (grey) {
        mean_h = hp + hq;
    } else if (abs(hp - hq) > pi) {
        mean_h += mean_h < pi ? pi : -pi;
    }
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
