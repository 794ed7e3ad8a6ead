#include "lutlib/metrics/climb.h"

#include "lutlib/metrics/samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>

namespace lutlib {
namespace {

// Many look around a little, the highest of them longer.
struct Round {
    std::size_t climbers, looks;
};
constexpr std::array<Round, 4> rounds{{{1024, 2}, {256, 4}, {64, 8}, {12, 30}}};
constexpr std::size_t all_looks = [] {
    std::size_t sum = 0;
    for (const Round& round : rounds) {
        sum += round.looks;
    }
    return sum;
}();
constexpr std::size_t directions = 24;
constexpr std::size_t candidates = 16384;
constexpr float shrink = 0.75F;

using Axes = std::array<std::vector<float>, 3>;
using Cell = std::array<std::size_t, 3>;

Cell cell_of(const Axes& axis, Rgb at) {
    Cell out{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto above = std::upper_bound(axis[c].begin() + 1, axis[c].end() - 1, at[c]);
        out[c] = static_cast<std::size_t>(above - axis[c].begin()) - 1;
    }
    return out;
}

// The wider of the gaps on both sides.
Rgb reach_at(const Axes& axis, const Cell& cell) {
    Rgb out;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto gap = [&](std::size_t i) { return axis[c][i + 1] - axis[c][i]; };
        out[c] = std::max(gap(cell[c]), cell[c] > 0 ? gap(cell[c] - 1) : 0.0F);
    }
    return out;
}

std::vector<std::size_t> seeds_of(std::span<const Rgb> colors, std::span<const double> errors,
                                  const Axes& axis) {
    std::vector<std::uint32_t> order(colors.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto count = static_cast<std::ptrdiff_t>(std::min<std::size_t>(candidates, order.size()));
    const auto worse = [&](std::uint32_t a, std::uint32_t b) {
        return errors[a] != errors[b] ? errors[a] > errors[b] : a < b;
    };
    std::nth_element(order.begin(), order.begin() + count, order.end(), worse);
    std::sort(order.begin(), order.begin() + count, worse);
    std::vector<std::size_t> out;
    std::set<Cell> taken;
    for (std::ptrdiff_t i = 0; i < count && out.size() < rounds[0].climbers; ++i) {
        const std::size_t k = order[static_cast<std::size_t>(i)];
        if (taken.insert(cell_of(axis, colors[k])).second) {
            out.push_back(k);
        }
    }
    return out;
}

// Where a climber looks around itself, in shares of its reach: evenly in -1..1, and nearer.
std::vector<Rgb> looks_around() {
    std::vector<Rgb> out = sample_colors(
        2, {.neutral = 0, .random = static_cast<int>(all_looks * directions), .lattice = false});
    out.erase(out.begin(), out.begin() + 8);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float nearer = i % 3 == 0 ? 1.0F : i % 3 == 1 ? 0.3F : 0.1F;
        out[i] = (out[i] * 2.0F - Rgb{1, 1, 1}) * nearer;
    }
    return out;
}

struct Climber {
    Peak peak;
    Rgb reach;
};

// Those that look around together: a call of a foreign process costs more than some colours.
std::size_t group_of(std::size_t climbers) {
    return std::clamp<std::size_t>(climbers / 16, 4, 32);
}

// Ridges run in any direction, so each look is in others.
void climb(std::span<Climber> climbers, std::span<const Rgb> around, const Axes& axis,
           const ErrorsOf& errors_of) {
    std::vector<Rgb> next(climbers.size() * directions);
    std::vector<double> error(next.size());
    for (; !around.empty(); around = around.subspan(directions)) {
        for (std::size_t i = 0; i < next.size(); ++i) {
            const Climber& climber = climbers[i / directions];
            for (std::size_t c = 0; c < 3; ++c) {
                next[i][c] =
                    std::clamp(climber.peak.at[c] + around[i % directions][c] * climber.reach[c],
                               axis[c].front(), axis[c].back());
            }
        }
        errors_of(next, error);
        for (std::size_t k = 0; k < climbers.size(); ++k) {
            const auto first = error.begin() + static_cast<std::ptrdiff_t>(k * directions);
            const auto best = static_cast<std::size_t>(std::max_element(first, first + directions) -
                                                       error.begin());
            if (error[best] > climbers[k].peak.error) {
                climbers[k].peak = {error[best], next[best]};
            } else {
                climbers[k].reach = climbers[k].reach * shrink;
            }
        }
    }
}

} // namespace

Peak climbed(std::span<const Rgb> colors, std::span<const double> errors,
             const std::array<std::vector<float>, 3>& axis, const ErrorsOf& errors_of) {
    if (colors.empty()) {
        return {};
    }
    const std::vector<std::size_t> seeds = seeds_of(colors, errors, axis);
    if (!(errors[seeds.front()] > 0) || std::isinf(errors[seeds.front()])) {
        return {errors[seeds.front()], colors[seeds.front()]};
    }
    std::vector<Climber> climbers;
    for (const std::size_t seed : seeds) {
        climbers.push_back(
            {{errors[seed], colors[seed]}, reach_at(axis, cell_of(axis, colors[seed]))});
    }
    const std::vector<Rgb> around = looks_around();
    std::size_t looked = 0;
    for (const Round& round : rounds) {
        climbers.resize(std::min(climbers.size(), round.climbers));
        const std::size_t group = group_of(climbers.size());
        tbb::parallel_for(
            std::size_t{0}, (climbers.size() + group - 1) / group, [&](std::size_t i) {
                const std::size_t first = i * group;
                climb(std::span(climbers).subspan(first, std::min(group, climbers.size() - first)),
                      std::span(around).subspan(looked * directions, round.looks * directions),
                      axis, errors_of);
            });
        looked += round.looks;
        std::sort(climbers.begin(), climbers.end(),
                  [](const Climber& a, const Climber& b) { return a.peak.error > b.peak.error; });
    }
    return climbers.front().peak;
}

} // namespace lutlib
