#include "preview/finish/tonemaps.h"

#include "lutlib/color/matrix.h"
#include "lutlib/color/transfer.h"
#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace preview {

namespace {

using lutlib::Matrix3;
using lutlib::RgbD;
using lutlib::saturate;
using lutlib::srgb_encode;

template <class F>
RgbD per_channel(RgbD c, F f) {
    return {f(c.r), f(c.g), f(c.b)};
}

// Written so that NaN becomes 0.
RgbD sane(RgbD c) {
    return per_channel(c, [](double v) { return v > 0 ? std::min(v, 65504.0) : 0; });
}

RgbD encode(RgbD c) {
    return per_channel(saturate(c), srgb_encode);
}

// Reinhard et al. 2002, "Photographic tone reproduction for digital images", per channel.
double reinhard(double v) {
    return srgb_encode(v / (1 + v));
}

// Hable 2010, "Uncharted 2: HDR lighting", with the exposure, white point and 1/2.2 of Piccolo's
// tone mapping shader.
double uncharted2(double v) {
    constexpr double a = 0.15, b = 0.50, c = 0.10, d = 0.20, e = 0.02, f = 0.30;
    constexpr double exposure = 4.5, white = 11.2;
    const auto curve = [](double x) {
        return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
    };
    return std::pow(std::max(curve(exposure * v) / curve(white), 0.0), 1 / 2.2);
}

// Narkowicz 2016, "ACES filmic tone mapping curve".
double aces_narkowicz(double v) {
    return srgb_encode(v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14));
}

// Hill's fit of the ACES reference and sRGB output transforms (BakingLab, 2016).
RgbD aces_hill(RgbD light) {
    constexpr Matrix3 in{
        {{{0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}}}};
    constexpr Matrix3 out{{{{1.60475, -0.53108, -0.07367},
                            {-0.10208, 1.10813, -0.00605},
                            {-0.00327, -0.07276, 1.07602}}}};
    const RgbD fitted = per_channel(in * light, [](double v) {
        return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    });
    return encode(out * fitted);
}

// Sobotka's AgX, base look: an inset of the primaries, log2 over 16.5 stops, a sigmoid about middle
// grey in closed form, the inset undone. The result is already display-encoded (power 2.2).
RgbD agx(RgbD light) {
    constexpr Matrix3 inset{{{{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                              {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                              {0.0423756549057051, 0.0784336, 0.879142973793104}}}};
    constexpr Matrix3 outset{{{{1.19687900512017, -0.0980208811401368, -0.0990297440797205},
                               {-0.0528968517574562, 1.15190312990417, -0.0989611768448433},
                               {-0.0529716355144438, -0.0980434501171241, 1.15107367264116}}}};
    constexpr double low = -12.47393, high = 4.026069;
    constexpr double pivot = 10.0 / 16.5;
    const RgbD curved = per_channel(inset * light, [](double v) {
        const double x = saturate((std::log2(std::max(v, 1e-10)) - low) / (high - low));
        const double d = x - pivot;
        const double bend = d > 0 ? std::pow(1 + 69.86278913545539 * std::pow(d, 3.25), -4.0 / 13)
                                  : std::pow(1 - 59.507875 * d * d * d, -1.0 / 3);
        return 0.5 + 2 * d * bend;
    });
    return saturate(outset * curved);
}

// Khronos PBR Neutral tone mapper (2024).
RgbD khronos_neutral(RgbD c) {
    constexpr double f90 = 0.04, start = 0.8 - f90, desaturation = 0.15;
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

constexpr auto tonemap_rows = std::to_array<Tonemap>({
    {.name = "aces-hill", .label = "ACES (Hill)", .mix = aces_hill, .shader = "aces_hill"},
    {.name = "aces-narkowicz", .label = "ACES (Narkowicz)", .curve = aces_narkowicz},
    {.name = "agx", .label = "AgX, codes of power 2.2", .mix = agx, .shader = "agx"},
    {.name = "khronos-neutral",
     .label = "Khronos PBR Neutral",
     .mix = khronos_neutral,
     .shader = "khronos_neutral"},
    {.name = "reinhard", .label = "Reinhard", .curve = reinhard},
    {.name = "uncharted2",
     .label = "Uncharted 2, as in Piccolo, codes of power 2.2",
     .curve = uncharted2},
    {.name = "none", .label = "none: clip at 1", .curve = srgb_encode},
});

std::vector<float> tabulate(const Tonemap& row) {
    std::vector<float> values;
    if (row.curve == nullptr) {
        return values;
    }
    for (int node = 0; node < ToneCurve::size; ++node) {
        const double mantissa = 1 + static_cast<double>(node % ToneCurve::nodes) / ToneCurve::nodes;
        const int exponent = ToneCurve::lowest + node / ToneCurve::nodes;
        values.push_back(static_cast<float>(row.curve(std::ldexp(mantissa, exponent))));
    }
    return values;
}

} // namespace

RgbD Tonemap::apply(RgbD light) const {
    const RgbD c = sane(light);
    return curve != nullptr ? saturate(per_channel(c, curve)) : mix(c);
}

std::span<const Tonemap> tonemaps() {
    return tonemap_rows;
}

const Tonemap* tonemap_named(std::string_view name) {
    return lutlib::find_named(tonemap_rows, name);
}

int index_of(const Tonemap& row) {
    return static_cast<int>(&row - tonemap_rows.data());
}

std::span<const float> tabulated_curve(const Tonemap& row) {
    static const auto curves = [] {
        std::array<std::vector<float>, tonemap_rows.size()> made;
        std::transform(tonemap_rows.begin(), tonemap_rows.end(), made.begin(), tabulate);
        return made;
    }();
    return curves[static_cast<std::size_t>(index_of(row))];
}

} // namespace preview
