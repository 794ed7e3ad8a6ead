// White balance: the white of the light that lit the scene is adapted to the recipe's white.
//
// The light's chromaticity lies on the Planckian locus, moved in parallel so that 6504 K is D65
// itself, and off it by the tint, which CIE 1960 measures as Duv.
#include "lutlib/ops/white_balance.h"

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

/// Across the locus, towards green, of length 1.
Uv across(double kelvin) {
    const double step = kelvin * 1e-4;
    const Uv here = planckian(kelvin), hotter = planckian(kelvin + step);
    const double du = hotter.u - here.u, dv = hotter.v - here.v, length = std::hypot(du, dv);
    const double sign = du > 0 ? 1 : -1;
    return {sign * -dv / length, sign * du / length};
}

Uv uv_of(Chromaticity c) {
    const double d = -2 * c.x + 12 * c.y + 3;
    return {4 * c.x / d, 6 * c.y / d};
}

/// The moved locus.
Uv locus(double kelvin) {
    const Uv here = planckian(kelvin), neutral = planckian(neutral_kelvin), d65 = uv_of(white_d65);
    return {d65.u + here.u - neutral.u, d65.v + here.v - neutral.v};
}

Chromaticity light(double kelvin, double tint) {
    const Uv on = locus(kelvin), green = across(kelvin);
    const double duv = tint / 1000;
    const double u = on.u + duv * green.u, v = on.v + duv * green.v;
    return {3 * u / (2 * u - 8 * v + 4), 2 * v / (2 * u - 8 * v + 4)};
}

/// To XYZ in which the primaries' white is D65.
Matrix3 to_xyz_of(const Primaries& primaries) {
    return adapted(primaries.white, white_d65) * rgb_to_xyz(primaries);
}

// On linear light of the primaries. Adaptation alone would make grey lighter or darker; scaled, its
// luminance stays.
Matrix3 balance(double kelvin, double tint, const Primaries& primaries) {
    const Matrix3 to_xyz = to_xyz_of(primaries);
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

// The temperature whose line across the moved locus goes through a chromaticity: from the best of a
// few over mireds, in which the locus is nearly even, for far from it there are two. Beyond the
// range the nearer of its ends.
double kelvin_of(Uv at) {
    const auto away = [at](double mired) {
        const Uv on = locus(1e6 / mired);
        return std::hypot(at.u - on.u, at.v - on.v);
    };
    // Along the locus, as seen from the line.
    const auto beside = [at](double mired) {
        const Uv on = locus(1e6 / mired), green = across(1e6 / mired);
        return (at.u - on.u) * green.v - (at.v - on.v) * green.u;
    };
    const double first = 1e6 / white_balance_parameters[0].max,
                 last = 1e6 / white_balance_parameters[0].min;
    constexpr int tried = 32;
    const double step = (last - first) / tried;
    double best = first;
    for (int i = 1; i <= tried; ++i) {
        const double mired = first + step * i;
        best = away(mired) < away(best) ? mired : best;
    }
    double low = std::max(first, best - step), high = std::min(last, best + step);
    const bool rises = beside(high) > beside(low);
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        ((beside(middle) > 0) == rises ? high : low) = middle;
    }
    return std::clamp(1e6 / ((low + high) / 2), white_balance_parameters[0].min,
                      white_balance_parameters[0].max);
}

} // namespace

std::optional<WhiteBalance> white_balance_of(RgbD light, const Primaries& primaries) {
    const RgbD xyz = to_xyz_of(primaries) * light;
    const double sum = xyz.r + xyz.g + xyz.b;
    if (!(std::min({xyz.r, xyz.g, xyz.b}) > 0) || !std::isfinite(sum)) {
        return std::nullopt;
    }
    const Uv at = uv_of({xyz.r / sum, xyz.g / sum});
    const double kelvin = kelvin_of(at);
    const Uv on = locus(kelvin), green = across(kelvin);
    const double duv = (at.u - on.u) * green.u + (at.v - on.v) * green.v;
    const Parameter& tint = white_balance_parameters[1];
    return WhiteBalance{kelvin, std::clamp(1000 * duv, tint.min, tint.max)};
}

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
