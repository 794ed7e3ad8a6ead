// A look's 1D table: where it falls and where it stands still.
#include "lutlib/health/parts.h"

#include <algorithm>
#include <cmath>

namespace lutlib::health {
namespace {

struct Counts {
    std::size_t low = 0, high = 0, flat = 0;
    std::size_t low_at = 0, high_at = 0, flat_at = 0; ///< where each begins
};

Counts flat_segments(const Lut1D& curve, std::size_t c, double rounding) {
    double lowest = INFINITY, highest = -INFINITY;
    for (const Rgb& entry : curve.entries) {
        if (std::isfinite(entry[c])) {
            lowest = std::min(lowest, static_cast<double>(entry[c]));
            highest = std::max(highest, static_cast<double>(entry[c]));
        }
    }
    Counts out;
    for (std::size_t k = 0; k + 1 < curve.entries.size(); ++k) {
        const double a = curve.entries[k][c], b = curve.entries[k + 1][c];
        // Long tables rise by less than the rounding from entry to entry; equal is equal.
        if (!(a == b)) {
            continue;
        }
        if (lowest < highest - rounding && a == lowest) {
            out.low_at = k;
            ++out.low;
        } else if (lowest < highest - rounding && a == highest) {
            out.high_at = out.high == 0 ? k : out.high_at;
            ++out.high;
        } else {
            out.flat_at = out.flat == 0 ? k : out.flat_at;
            ++out.flat;
        }
    }
    return out;
}

} // namespace

CurveExamined examine_curve(const Lut1D& curve, const Lut3D* cube, double rounding) {
    CurveExamined out;
    const auto segments = static_cast<double>(curve.entries.size() - 1);
    const auto place = [&](std::size_t k) {
        return to_float(entry_position(curve, static_cast<int>(k)));
    };
    for (std::size_t c = 0; c < 3; ++c) {
        const bool rises = curve.entries.back()[c] >= curve.entries.front()[c];
        for (std::size_t k = 0; k + 1 < curve.entries.size(); ++k) {
            const double step = static_cast<double>(curve.entries[k + 1][c]) -
                                static_cast<double>(curve.entries[k][c]);
            const double fall = rises ? -step : step;
            if (fall > std::max(rounding, out.shaper.shaper_fall[c].value)) {
                out.shaper.shaper_fall[c] = {fall, place(k)};
            }
        }
        const Counts counts = flat_segments(curve, c, rounding);
        const auto share = [&](std::size_t n) { return static_cast<double>(n) / segments; };
        if (!cube) {
            out.table.clipped_low[c] = {share(counts.low), place(counts.low_at)};
            out.table.clipped_high[c] = {share(counts.high), place(counts.high_at)};
        }
        const double flat = share(cube ? counts.low + counts.high + counts.flat : counts.flat);
        if (flat > out.table.plateau.value) {
            const std::size_t at = counts.flat   ? counts.flat_at
                                   : counts.high ? counts.high_at
                                                 : counts.low_at;
            out.table.plateau = {flat, place(at)};
        }
        for (std::size_t k = 0; cube && k < curve.entries.size(); ++k) {
            const float value = curve.entries[k][c];
            out.shaper.cut_off += std::isfinite(value) &&
                                  (value < cube->domain.min[c] || value > cube->domain.max[c]);
        }
    }
    if (cube) {
        return out;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 1; k + 1 < curve.entries.size(); ++k) {
            const double d = static_cast<double>(curve.entries[k - 1][c]) -
                             2 * static_cast<double>(curve.entries[k][c]) +
                             static_cast<double>(curve.entries[k + 1][c]);
            if (std::abs(d) > out.table.second_difference.value) {
                out.table.second_difference = {std::abs(d), place(k)};
            }
        }
    }
    return out;
}

} // namespace lutlib::health
