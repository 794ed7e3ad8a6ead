// Constants that one distance and many at once share.
#pragma once

#include "lutlib/color/primaries.h"

namespace lutlib {

inline constexpr Matrix3 rec709_to_xyz = rgb_to_xyz(rec709);
inline constexpr RgbD lab_white = rec709_to_xyz * RgbD{1, 1, 1};

// CIE 15:2004, section 8.2.1: below delta^3 the curve is linear.
inline constexpr double lab_delta = 6.0 / 29;
inline constexpr double lab_cut = lab_delta * lab_delta * lab_delta;
inline constexpr double lab_slope = 1 / (3 * lab_delta * lab_delta);
inline constexpr double lab_offset = 4.0 / 29;

// ITU-R BT.2100-2 table 7, with the T axis of BT.2124 (half of Ct).
inline constexpr Matrix3 rec2020_to_lms{{{{1688.0 / 4096, 2146.0 / 4096, 262.0 / 4096},
                                          {683.0 / 4096, 2951.0 / 4096, 462.0 / 4096},
                                          {99.0 / 4096, 309.0 / 4096, 3688.0 / 4096}}}};
inline constexpr Matrix3 pq_lms_to_itp{
    {{{0.5, 0.5, 0},
      {0.5 * 6610 / 4096, -0.5 * 13613 / 4096, 0.5 * 7003 / 4096},
      {17933.0 / 4096, -17390.0 / 4096, -543.0 / 4096}}}};

} // namespace lutlib
