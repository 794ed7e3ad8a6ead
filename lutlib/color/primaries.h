// RGB primaries, their matrices to CIE XYZ, and chromatic adaptation between whites.
#pragma once

#include "lutlib/color/matrix.h"

#include <string_view>

namespace lutlib {

/// CIE 1931 chromaticity.
struct Chromaticity {
    double x = 0, y = 0;
    friend constexpr bool operator==(const Chromaticity&, const Chromaticity&) = default;
};

struct Primaries {
    std::string_view name;
    Chromaticity red, green, blue, white;
};

inline constexpr Chromaticity white_d65{0.3127, 0.3290};
inline constexpr Primaries rec709{"Rec.709", {.64, .33}, {.30, .60}, {.15, .06}, white_d65};
inline constexpr Primaries rec2020{"Rec.2020", {.708, .292}, {.170, .797}, {.131, .046}, white_d65};
inline constexpr Primaries arri_wide_gamut3{
    "ARRI Wide Gamut 3", {.6840, .3130}, {.2210, .8480}, {.0861, -.1020}, white_d65};
inline constexpr Primaries aces_ap1{
    "ACES AP1", {.713, .293}, {.165, .830}, {.128, .044}, {.32168, .33767}};

/// XYZ with Y = 1.
constexpr RgbD xyz_of(Chromaticity c) {
    return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

/// SMPTE RP 177: linear RGB to XYZ, the white to Y = 1.
constexpr Matrix3 rgb_to_xyz(const Primaries& p) {
    const RgbD r = xyz_of(p.red), g = xyz_of(p.green), b = xyz_of(p.blue);
    const Matrix3 columns{{{{r.r, g.r, b.r}, {r.g, g.g, b.g}, {r.b, g.b, b.b}}}};
    return columns * diagonal(inverse(columns) * xyz_of(p.white));
}

/// Bradford's linear adaptation (Lam 1985; ICC.1:2010 annex E) of XYZ from one white to another.
constexpr Matrix3 bradford_adaptation(Chromaticity from, Chromaticity to) {
    constexpr Matrix3 cone{
        {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}}};
    const RgbD a = cone * xyz_of(from), b = cone * xyz_of(to);
    return inverse(cone) * diagonal({b.r / a.r, b.g / a.g, b.b / a.b}) * cone;
}

/// Linear RGB of one set to linear RGB of another; whites map to each other.
constexpr Matrix3 rgb_to_rgb(const Primaries& from, const Primaries& to) {
    return inverse(rgb_to_xyz(to)) * bradford_adaptation(from.white, to.white) * rgb_to_xyz(from);
}

} // namespace lutlib
