// The published constants of SMPTE ST 2084.
#pragma once

namespace lutlib {

inline constexpr double pq_white_nits = 100;

namespace pq {
inline constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 4096 * 128, c1 = 3424.0 / 4096,
                        c2 = 2413.0 / 4096 * 32, c3 = 2392.0 / 4096 * 32, peak = 10000;
}

} // namespace lutlib
