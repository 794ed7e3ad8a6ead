// RGB primaries, their matrices to CIE XYZ, and chromatic adaptation between whites.
#pragma once

#include "lutlib/color/matrix.h"

#include <span>
#include <string_view>

namespace lutlib {

/// CIE 1931 chromaticity.
struct Chromaticity {
    double x = 0, y = 0;
    friend constexpr bool operator==(const Chromaticity&, const Chromaticity&) = default;
};

struct Primaries {
    Chromaticity red, green, blue, white;
    friend constexpr bool operator==(const Primaries&, const Primaries&) = default;
};

inline constexpr Chromaticity white_d65{0.3127, 0.3290};
/// ITU-R BT.709-6, item 1.4; IEC 61966-2-1 has the same.
inline constexpr Primaries rec709{{.64, .33}, {.30, .60}, {.15, .06}, white_d65};
/// ITU-R BT.2020-2, table 3.
inline constexpr Primaries rec2020{{.708, .292}, {.170, .797}, {.131, .046}, white_d65};

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

/// One way of adapting colours to another white: a scaling of these cone responses.
struct Adaptation {
    std::string_view name, label, source;
    Matrix3 cones; ///< of XYZ
};

inline constexpr Adaptation bradford{
    .name = "bradford",
    .label = "Bradford, linear",
    .source = "Lam 1985; ICC.1:2010, annex E",
    .cones = {{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}}}};
inline constexpr Adaptation cat02{
    .name = "cat02",
    .label = "CAT02, full adaptation",
    .source = "CIE 159:2004, CIECAM02",
    .cones = {{{{0.7328, 0.4296, -0.1624}, {-0.7036, 1.6975, 0.0061}, {0.0030, 0.0136, 0.9834}}}}};

/// bradford, which is the default everywhere, and cat02.
std::span<const Adaptation* const> adaptations();
/// Null for an unknown name.
const Adaptation* adaptation_named(std::string_view name);

/// XYZ under one white to the same colour's under another.
constexpr Matrix3 adapted(Chromaticity from, Chromaticity to, const Adaptation& how = bradford) {
    const RgbD a = how.cones * xyz_of(from), b = how.cones * xyz_of(to);
    return inverse(how.cones) * diagonal({b.r / a.r, b.g / a.g, b.b / a.b}) * how.cones;
}

/// Linear RGB of one set to linear RGB of another; whites map to each other.
constexpr Matrix3 rgb_to_rgb(const Primaries& from, const Primaries& to,
                             const Adaptation& how = bradford) {
    return inverse(rgb_to_xyz(to)) * adapted(from.white, to.white, how) * rgb_to_xyz(from);
}

} // namespace lutlib
