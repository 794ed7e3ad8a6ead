// CIE 1976 uniform chromaticity scale (CIE 15:2004, 8.1 and 8.2).
#pragma once

#include "lutlib/color/primaries.h"

#include <cmath>

namespace lutlib {

/// u' and v'.
struct UcsPlace {
    double u = 0, v = 0;
};

/// Of X, Y, Z; not finite for black.
constexpr UcsPlace ucs_of(RgbD xyz) {
    const double sum = xyz.r + 15 * xyz.g + 3 * xyz.b;
    return {4 * xyz.r / sum, 9 * xyz.g / sum};
}
constexpr UcsPlace ucs_of(Chromaticity c) {
    return ucs_of(xyz_of(c));
}

/// The CIE 1976 saturation s_uv: 13 times the distance from white. It does not change with
/// luminance alone.
inline double ucs_saturation(UcsPlace color, UcsPlace white) {
    return 13 * std::hypot(color.u - white.u, color.v - white.v);
}

} // namespace lutlib
