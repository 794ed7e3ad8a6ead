// White balance: the white of the light that lit the scene is adapted to the recipe's white.
//
// The light's chromaticity lies on the Planckian locus, moved in parallel so that 6504 K is D65
// itself, and off it by the tint, which CIE 1960 measures as Duv.
#include "lutlib/ops/all.h"

#include <cmath>

namespace lutlib::op {
namespace {

constexpr double neutral_kelvin = 6504;

constexpr Parameter parameters[] = {
    {.name = "temperature",
     .flag = "temperature",
     .label = "Temperature",
     .unit = "K",
     .min = 2000,
     .max = 15000,
     .fallback = neutral_kelvin},
    {.name = "tint",
     .flag = "tint",
     .label = "Tint",
     .unit = "1000 Duv",
     .min = -50,
     .max = 50,
     .fallback = 0},
};

struct Uv {
    double u, v;
};

// M. Krystek, "An algorithm to calculate correlated colour temperature", Color Research and
// Application 10, 1985; 1000 K to 15000 K within 1e-4 of the locus.
Uv planckian(double kelvin) {
    const double t = kelvin, t2 = t * t;
    return {(0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t2) /
                (1 + 8.42420235e-4 * t + 7.08145163e-7 * t2),
            (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t2) /
                (1 - 2.89741816e-5 * t + 1.61456053e-7 * t2)};
}

Chromaticity light(double kelvin, double tint) {
    const double step = kelvin * 1e-4;
    const Uv here = planckian(kelvin), hotter = planckian(kelvin + step);
    const Uv neutral = planckian(neutral_kelvin);
    // Across the locus, towards green.
    const double du = hotter.u - here.u, dv = hotter.v - here.v, length = std::hypot(du, dv);
    const Uv green{dv / -length, du / length};
    const double sign = green.v > 0 ? 1 : -1;
    const double d65 = -2 * white_d65.x + 12 * white_d65.y + 3;
    const double duv = sign * tint / 1000;
    const double u = 4 * white_d65.x / d65 + here.u - neutral.u + duv * green.u;
    const double v = 6 * white_d65.y / d65 + here.v - neutral.v + duv * green.v;
    return {3 * u / (2 * u - 8 * v + 4), 2 * v / (2 * u - 8 * v + 4)};
}

Transform compile(const Values& values, const OpContext& context) {
    const double kelvin = std::get<double>(values[0]), tint = std::get<double>(values[1]);
    if (kelvin == neutral_kelvin && tint == 0) {
        return {};
    }
    Primaries d65 = context.primaries;
    const Matrix3 to_xyz = adapted(d65.white, white_d65) * rgb_to_xyz(context.primaries);
    const Matrix3 m = inverse(to_xyz) * adapted(light(kelvin, tint), white_d65) * to_xyz;
    return Transform::each([m](RgbD c) { return m * c; });
}

} // namespace

const Op white_balance{
    .name = "white-balance",
    .label = "White balance",
    .help = "Adapts the white of the light that lit the scene to neutral; more kelvin is warmer, "
            "more tint is more magenta",
    .reference = "Krystek 1985 for the light, Bradford adaptation (Lam 1985) in linear light",
    .space = Space::linear,
    .parameters = parameters,
    .compile = compile};

} // namespace lutlib::op
