#include "lutlib/match/greys.h"

#include "lutlib/nodes.h"
#include "lutlib/rising.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lutlib {
namespace {

// So that a node without support follows those that have it, and still has a place of its own.
constexpr double least_support = 1e-3;
// Of the width of the lattice, where nodes beside the greys no longer follow them.
constexpr double widest_reach = 0.25;
// A fall that its pixels say: beyond so many standard deviations of their mean, in any case from
// the larger of these on, and never below the smaller.
constexpr double certain = 3, least_fall = 0.5 / 255, largest_chance = 2 / 255.0;

// By how much each node of the diagonal has to move.
std::vector<double> moves(const Lut3D& cube, std::span<const double> support, std::size_t channel) {
    std::vector<double> values, weights;
    for (int i = 0; i < cube.size; ++i) {
        values.push_back(static_cast<double>(cube.at(i, i, i)[channel]));
        weights.push_back(least_support + support[cube.index(i, i, i)]);
    }
    const double sense = values.back() < values.front() ? -1 : 1;
    for (double& value : values) {
        value *= sense;
    }
    std::vector<double> out = rising(values, weights);
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = sense * (out[i] - values[i]);
    }
    return out;
}

} // namespace

std::array<bool, 3> make_greys_rise(Lut3D& cube, std::span<const double> support, double noise) {
    std::array<bool, 3> out{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::vector<double> move = moves(cube, support, channel);
        for (int i = 0; i < cube.size; ++i) {
            const double pixels = support[cube.index(i, i, i)];
            out[channel] =
                out[channel] || (pixels > 0 && std::abs(move[static_cast<std::size_t>(i)]) >
                                                   std::clamp(certain * noise / std::sqrt(pixels),
                                                              least_fall, largest_chance));
        }
        if (out[channel]) {
            continue;
        }
        for_each_node(cube.size, [&](int r, int g, int b) {
            const double aside = std::max({r, g, b}) - std::min({r, g, b});
            const double nearness = 1 - aside / (widest_reach * (cube.size - 1));
            if (nearness > 0) {
                const double place = (r + g + b) / 3.0;
                const auto i = static_cast<std::size_t>(place);
                const double by = std::lerp(move[i], move[std::min(i + 1, move.size() - 1)],
                                            place - static_cast<double>(i));
                cube.at(r, g, b)[channel] += static_cast<float>(nearness * by);
            }
        });
    }
    return out;
}

} // namespace lutlib
