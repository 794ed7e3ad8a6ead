// The published constants of the transfer curves.
#pragma once

namespace lutlib {

inline constexpr double largest_light = 65504;
inline constexpr double pq_white_nits = 100;

/// ARRI, EI 800.
namespace logc3 {
inline constexpr double cut = 0.010591, a = 5.555556, b = 0.052272, c = 0.247190, d = 0.385537,
                        e = 5.367655, f = 0.092809;
}

/// S-2016-001.
namespace acescct {
inline constexpr double code_cut = 0.155251141552511, light_cut = 0.0078125,
                        slope = 10.5402377416545, offset = 0.0729055341958355, stops = 17.52,
                        lowest = 9.72;
}

/// SMPTE ST 2084.
namespace pq {
inline constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 4096 * 128, c1 = 3424.0 / 4096,
                        c2 = 2413.0 / 4096 * 32, c3 = 2392.0 / 4096 * 32, peak = 10000;
}

} // namespace lutlib
