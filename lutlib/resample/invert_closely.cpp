#include "lutlib/resample/invert_closely.h"

#include "lutlib/resample/invert_shaper.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace lutlib {
namespace {

// Cells to search for all nodes: about ten seconds.
constexpr double most_work = 5e7;
// A lattice of this share of the largest is followed by none.
constexpr double nearly = 0.9;

using Attempts = std::vector<ClosestInversion::Attempt>;

// What a finer lattice will err by, if it gains as the last one did on the one before.
double expected(const Attempts& attempts, int size) {
    const auto& last = attempts.back();
    const auto before = std::find_if(attempts.rbegin() + 1, attempts.rend(), [&](const auto& a) {
        return a.shaper == last.shaper && a.size < last.size;
    });
    if (before == attempts.rend()) {
        return 0;
    }
    const auto finer = [](int a, int b) { return std::log(static_cast<double>(b) / a); };
    return last.p99 * std::pow(last.p99 / before->p99,
                               finer(last.size, size) / finer(before->size, last.size));
}

// The next size to try; nothing where none is worth it.
std::optional<int> next_size(const Attempts& attempts, const RoundTripAim& aim, double work) {
    const int size = attempts.back().size;
    const bool usual = size < nearly * aim.largest;
    const int next = usual ? std::min(2 * size - 1, aim.largest) : aim.furthest;
    const bool affordable = work * std::pow(next, 3) <= most_work;
    const bool promises = usual || (size < nearly * next && expected(attempts, next) <= aim.p99);
    return affordable && promises ? std::optional(next) : std::nullopt;
}

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
    // Whether there is no more to do.
    const auto attempt = [&](int size, std::string shaper) {
        Inversion now = inverter.of(size, shaper);
        if (now.undoable.empty()) {
            out = {.inversion = std::move(now)};
            return true;
        }
        const double p99 =
            compare({}, round_trip(look, now.lut), now.undoable, inputs).delta_e_2000.p99;
        const bool is_best = std::all_of(out.attempts.begin(), out.attempts.end(),
                                         [&](const auto& before) { return p99 < before.p99; });
        out.attempts.push_back({size, p99, std::move(shaper)});
        if (is_best) {
            out.inversion = std::move(now);
        }
        out.kept = p99 <= aim.p99;
        return out.kept;
    };
    if (attempt(own_inverse_size(look), options.shaper)) {
        return out;
    }
    if (options.shaper.empty()) {
        if (attempt(own_inverse_size(look), std::string(outputs_shaper))) {
            return out;
        }
        if (out.attempts[0].p99 <= out.attempts[1].p99) {
            std::swap(out.attempts[0], out.attempts[1]);
        }
    }
    while (const auto size = next_size(out.attempts, aim, inverter.work())) {
        if (attempt(*size, out.attempts.back().shaper)) {
            break;
        }
    }
    return out;
}

} // namespace lutlib
