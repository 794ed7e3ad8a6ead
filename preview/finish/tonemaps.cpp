#include "preview/finish/tonemaps.h"

#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace preview {

namespace {

using lutlib::RgbD;
using Matrix = std::array<std::array<double, 3>, 3>;

// Written so that NaN becomes 0.
RgbD sane(RgbD c) {
    for (std::size_t i = 0; i < 3; ++i)
        c[i] = c[i] > 0 ? std::min(c[i], 65504.0) : 0;
    return c;
}

template <class F>
RgbD per_channel(RgbD c, F f) {
    return {f(c.r), f(c.g), f(c.b)};
}

RgbD multiply(const Matrix& m, RgbD c) {
    RgbD out;
    for (std::size_t row = 0; row < 3; ++row)
        out[row] = m[row][0] * c.r + m[row][1] * c.g + m[row][2] * c.b;
    return out;
}

double saturate(double v) {
    return std::clamp(v, 0.0, 1.0);
}

RgbD encode(RgbD c) {
    return per_channel(c, [](double v) { return srgb_encode(saturate(v)); });
}

RgbD none(RgbD light) {
    return encode(sane(light));
}

// Reinhard et al. 2002, "Photographic tone reproduction for digital images", per channel.
RgbD reinhard(RgbD light) {
    return encode(per_channel(sane(light), [](double v) { return v / (1 + v); }));
}

// Hable 2010, "Uncharted 2: HDR lighting", with the exposure, white point and 1/2.2 of Piccolo's
// tone mapping shader.
RgbD uncharted2(RgbD light) {
    constexpr double a = 0.15, b = 0.50, c = 0.10, d = 0.20, e = 0.02, f = 0.30;
    constexpr double exposure = 4.5, white = 11.2;
    const auto curve = [=](double x) {
        return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
    };
    return per_channel(sane(light), [&](double v) {
        return std::pow(saturate(curve(exposure * v) / curve(white)), 1 / 2.2);
    });
}

// Hill's fit of the ACES reference and sRGB output transforms (BakingLab, 2016).
RgbD aces_hill(RgbD light) {
    constexpr Matrix in{
        {{0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}}};
    constexpr Matrix out{{{1.60475, -0.53108, -0.07367},
                          {-0.10208, 1.10813, -0.00605},
                          {-0.00327, -0.07276, 1.07602}}};
    const RgbD fitted = per_channel(multiply(in, sane(light)), [](double v) {
        return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    });
    return encode(multiply(out, fitted));
}

// Narkowicz 2016, "ACES filmic tone mapping curve".
RgbD aces_narkowicz(RgbD light) {
    return encode(per_channel(sane(light), [](double v) {
        return v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14);
    }));
}

// Sobotka's AgX, base look: an inset of the primaries, log2 over 16.5 stops, a sigmoid about middle
// grey in closed form, the inset undone. The result is already display-encoded (power 2.2).
RgbD agx(RgbD light) {
    constexpr Matrix inset{{{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                            {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                            {0.0423756549057051, 0.0784336, 0.879142973793104}}};
    constexpr Matrix outset{{{1.19687900512017, -0.0980208811401368, -0.0990297440797205},
                             {-0.0528968517574562, 1.15190312990417, -0.0989611768448433},
                             {-0.0529716355144438, -0.0980434501171241, 1.15107367264116}}};
    constexpr double low = -12.47393, high = 4.026069;
    constexpr double pivot = 10.0 / 16.5;
    const RgbD curved = per_channel(multiply(inset, sane(light)), [](double v) {
        const double x = saturate((std::log2(std::max(v, 1e-10)) - low) / (high - low));
        const double d = x - pivot;
        const double bend = d > 0 ? std::pow(1 + 69.86278913545539 * std::pow(d, 3.25), -4.0 / 13)
                                  : std::pow(1 - 59.507875 * d * d * d, -1.0 / 3);
        return 0.5 + 2 * d * bend;
    });
    return per_channel(multiply(outset, curved), saturate);
}

// Khronos PBR Neutral tone mapper (2024).
RgbD khronos_neutral(RgbD light) {
    constexpr double f90 = 0.04, start = 0.8 - f90, desaturation = 0.15;
    RgbD c = sane(light);
    const double least = std::min({c.r, c.g, c.b});
    const double offset = least < 2 * f90 ? least - least * least / (4 * f90) : f90;
    c = per_channel(c, [&](double v) { return v - offset; });
    const double peak = std::max({c.r, c.g, c.b});
    if (peak > start) {
        constexpr double d = 1 - start;
        const double new_peak = 1 - d * d / (peak + d - start);
        const double grey = 1 - 1 / (desaturation * (peak - new_peak) + 1);
        c = per_channel(c,
                        [&](double v) { return std::lerp(v * new_peak / peak, new_peak, grey); });
    }
    return encode(c);
}

constexpr std::array<Tonemap, 7> table{{
    {"aces-hill", "ACES (Hill)", "sRGB", 0, aces_hill},
    {"aces-narkowicz", "ACES (Narkowicz)", "sRGB", 1, aces_narkowicz},
    {"agx", "AgX", "power 2.2", 2, agx},
    {"khronos-neutral", "Khronos PBR Neutral", "sRGB", 3, khronos_neutral},
    {"reinhard", "Reinhard", "sRGB", 4, reinhard},
    {"uncharted2", "Uncharted 2, as in Piccolo", "power 2.2", 5, uncharted2},
    {"none", "none: clip at 1", "sRGB", 6, none},
}};

} // namespace

double srgb_encode(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double srgb_decode(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

std::span<const Tonemap> tonemaps() {
    return table;
}

const Tonemap* tonemap_named(std::string_view name) {
    return lutlib::find_named(table, name);
}

} // namespace preview
