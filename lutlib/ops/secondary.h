// What the curves over hue, saturation and luminance share: their axes, and how much a hue counts.
//
// Saturation is Oklab chroma over that of sRGB's magenta (.3225), luminance is Oklab L. A change of
// luminance scales L, a and b together, which is a gain in linear light: chromaticity stays.
#pragma once

#include "lutlib/color/oklab.h"
#include "lutlib/ops/all.h"

#include <cmath>

namespace lutlib::op {

inline constexpr CurveAxis hue_axis{
    .label = "hue", .unit = "degrees, red at 0", .min = 0, .max = 360, .periodic = true};
inline constexpr CurveAxis saturation_axis{
    .label = "saturation", .unit = "Oklab chroma / .3225", .min = 0, .max = 2};
inline constexpr CurveAxis luminance_axis{
    .label = "luminance", .unit = "Oklab L", .min = 0, .max = 4};

constexpr Parameter curve_parameter(std::string_view flag, std::string_view label,
                                    std::string_view unit, double min, double max, double neutral,
                                    const CurveAxis& axis) {
    return {.name = "curve",
            .flag = flag,
            .label = label,
            .unit = unit,
            .kind = ParameterKind::curve,
            .min = min,
            .max = max,
            .fallback = neutral,
            .axis = axis};
}

inline double saturation_of(RgbD lab) {
    return std::hypot(lab.g, lab.b) / srgb_chroma;
}

/// 0 for a neutral, 1/2 at a tenth of full saturation, towards 1 beyond. It grows with the square
/// of chroma, so that what depends on hue fades out before hue loses its meaning.
inline double hue_weight(RgbD lab) {
    constexpr double half = 0.1 * srgb_chroma;
    const double c2 = lab.g * lab.g + lab.b * lab.b;
    return c2 / (c2 + half * half);
}

inline RgbD rotated(RgbD lab, double degrees) {
    const double t = degrees * 0.017453292519943295;
    const double c = std::cos(t), s = std::sin(t);
    return {lab.r, lab.g * c - lab.b * s, lab.g * s + lab.b * c};
}

inline RgbD with_chroma(RgbD lab, double factor) {
    return {lab.r, lab.g * factor, lab.b * factor};
}

} // namespace lutlib::op
