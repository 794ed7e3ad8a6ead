// White balance: the white of the light that lit the scene is adapted to the recipe's white.
//
// The light's chromaticity lies on the Planckian locus, moved in parallel so that 6504 K is D65
// itself, and off it by the tint, which CIE 1960 measures as Duv.
#include "lutlib/number_text.h"
#include "lutlib/ops/all.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib::op {
namespace {

constexpr double neutral_kelvin = 6504;

constexpr Parameter white_balance_parameters[] = {
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

// On linear light of the primaries. Adaptation alone would make grey lighter or darker; scaled, its
// luminance stays.
Matrix3 balance(double kelvin, double tint, const Primaries& primaries) {
    const Matrix3 to_xyz = adapted(primaries.white, white_d65) * rgb_to_xyz(primaries);
    const Matrix3 m = inverse(to_xyz) * adapted(light(kelvin, tint), white_d65) * to_xyz;
    const RgbD white{1, 1, 1};
    const double kept = (to_xyz * white).g / (to_xyz * (m * white)).g;
    return diagonal({kept, kept, kept}) * m;
}

Transform compile_white_balance(const Values& values, const OpContext& context) {
    const double kelvin = std::get<double>(values[0]), tint = std::get<double>(values[1]);
    if (kelvin == neutral_kelvin && tint == 0) {
        return {};
    }
    return Transform::each(
        [m = balance(kelvin, tint, context.primaries)](RgbD c) { return m * c; });
}

// Where grey gets negative light in the result, its codes are cut off there.
std::string note(const Values& values, const OpContext& context) {
    const double kelvin = std::get<double>(values[0]), tint = std::get<double>(values[1]);
    const Matrix3 shown = rgb_to_rgb(context.primaries, context.output, *context.adaptation);
    const auto white = [&](double at) {
        return shown * (balance(at, tint, context.primaries) * RgbD{1, 1, 1});
    };
    const auto is_inside = [&white](double at) {
        const RgbD c = white(at);
        return std::min({c.r, c.g, c.b}) >= 0;
    };
    if (is_inside(kelvin)) {
        return {};
    }
    const RgbD c = white(kelvin);
    const std::size_t channel = c.r < 0 ? 0 : c.g < 0 ? 1 : 2;
    constexpr std::array<std::string_view, 3> channels{"red", "green", "blue"};
    std::string out = "--temperature " + shortest(kelvin) +
                      " takes grey out of the result's gamut (" + std::string(channels[channel]) +
                      " of white is " + shortest(std::round(1000 * c[channel]) / 1000) + ")";
    if (!is_inside(neutral_kelvin)) {
        return out + "; choose a smaller --tint";
    }
    double outside = kelvin, within = neutral_kelvin;
    while (std::abs(outside - within) > 0.5) {
        const double middle = (outside + within) / 2;
        (is_inside(middle) ? within : outside) = middle;
    }
    const bool low = kelvin < neutral_kelvin;
    return out + "; with this tint it stays inside " + (low ? "from " : "up to ") +
           shortest(low ? std::ceil(within) : std::floor(within)) + " K";
}

} // namespace

const Op white_balance{
    .name = "white-balance",
    .label = "White balance",
    .help =
        "Adapts the white of the light that lit the scene to neutral and keeps the luminance of "
        "grey; more kelvin is warmer, more tint is more magenta. In Rec.709 grey has no red "
        "left below 2521 K",
    .reference = "Krystek 1985 for the light, Bradford adaptation (Lam 1985) in linear light",
    .space = Space::linear,
    .parameters = white_balance_parameters,
    .compile = compile_white_balance,
    .note = note};

} // namespace lutlib::op
