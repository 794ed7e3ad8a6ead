// Oklab (B. Ottosson, "A perceptual color space for image processing", 2020), with the matrices of
// CSS Color 4, which restate his to 16 digits for a D65 of 0.3127, 0.3290, and hues on the dial
// that colourists know.
#pragma once

#include "lutlib/color/primaries.h"

#include <cmath>

namespace lutlib {

/// A colour in Oklab is an RgbD of L (0..1 within the gamut), a, b.
inline constexpr Matrix3 oklab_xyz_to_lms{
    {{{0.8190224379967030, 0.3619062600528904, -0.1288737815209879},
      {0.0329836539323885, 0.9292868615863434, 0.0361446663506424},
      {0.0481771893596242, 0.2642395317527308, 0.6335478284694309}}}};
inline constexpr Matrix3 oklab_lms_to_lab{
    {{{0.2104542683093140, 0.7936177747023054, -0.0040720430116193},
      {1.9779985324311684, -2.4285922420485799, 0.4505937096174110},
      {0.0259040424655478, 0.7827717124575296, -0.8086757549230774}}}};
inline constexpr Matrix3 oklab_lab_to_lms = inverse(oklab_lms_to_lab);

/// The cone responses of linear light; the rows are scaled so that white is exactly 1, 1, 1.
constexpr Matrix3 oklab_cones(const Primaries& primaries) {
    const Matrix3 to_lms = oklab_xyz_to_lms * rgb_to_xyz(rec709) * rgb_to_rgb(primaries, rec709);
    const RgbD white = to_lms * RgbD{1, 1, 1};
    return diagonal({1 / white.r, 1 / white.g, 1 / white.b}) * to_lms;
}

inline RgbD oklab_from_lms(RgbD lms) {
    return oklab_lms_to_lab * RgbD{std::cbrt(lms.r), std::cbrt(lms.g), std::cbrt(lms.b)};
}

inline RgbD lms_from_oklab(RgbD lab) {
    const RgbD c = oklab_lab_to_lms * lab;
    return {c.r * c.r * c.r, c.g * c.g * c.g, c.b * c.b * c.b};
}

/// Of linear Rec.709.
RgbD oklab_from_linear(RgbD linear);
RgbD linear_from_oklab(RgbD lab);

/// The largest Oklab chroma of sRGB, magenta's: saturation 1 on the operators' curves.
inline constexpr double srgb_chroma = 0.3225;

/// Hue in degrees, 0 <= h < 360, of Oklab's a and b on a dial where the sRGB primaries and
/// secondaries stand at 0 (red), 60 (yellow), 120 (green), 180, 240 (blue) and 300; smooth between
/// them (C1). The hue of a neutral is 0.
double dial_hue(double a, double b);
/// The Oklab hue angle, 0 <= angle < 360 degrees, of a place on the dial; the inverse of dial_hue.
double oklab_hue(double dial);

} // namespace lutlib
