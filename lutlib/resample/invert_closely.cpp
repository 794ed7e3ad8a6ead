#include "lutlib/resample/invert_closely.h"

#include <algorithm>
#include <utility>

namespace lutlib {
namespace {

// Cells to search for all nodes: about ten seconds.
constexpr double most_work = 5e7;
// A lattice of this share of the largest is followed by none.
constexpr double nearly = 0.9;

} // namespace

Transform round_trip(const Lut& look, const Lut& inverse) {
    return in_sequence({Transform::of(look, Interpolation::tetrahedral),
                        Transform::of(inverse, Interpolation::tetrahedral)});
}

ClosestInversion invert_closely(const Lut& look, const InvertOptions& options,
                                const Viewing& inputs, const RoundTripAim& aim) {
    if (options.size || (look.shaper && !look.cube)) {
        return {.inversion = invert(look, options)};
    }
    const Inverter inverter(look, options);
    ClosestInversion out;
    for (int size = own_inverse_size(look);; size = std::min(2 * size - 1, aim.largest)) {
        Inversion now = inverter.of(size);
        if (now.undoable.empty()) {
            return {.inversion = std::move(now)};
        }
        const double p99 =
            compare({}, round_trip(look, now.lut), now.undoable, inputs).delta_e_2000.p99;
        const bool is_best = std::all_of(out.attempts.begin(), out.attempts.end(),
                                         [&](const auto& before) { return p99 < before.p99; });
        out.attempts.push_back({size, p99});
        if (is_best) {
            out.inversion = std::move(now);
        }
        out.kept = p99 <= aim.p99;
        const double finer = std::min(2.0 * size - 1, 1.0 * aim.largest);
        if (out.kept || size >= nearly * aim.largest ||
            finer * finer * finer * inverter.work() > most_work) {
            return out;
        }
    }
}

} // namespace lutlib
