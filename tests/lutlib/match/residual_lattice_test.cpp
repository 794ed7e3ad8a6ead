#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/match/residual_lattice.h"
#include "tests/lutlib/match/pairs.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

RgbD correction_at(RgbD c) {
    return {0.1 * c.r * c.g, 0.05 * std::sin(6 * c.g), -0.1 * c.b * c.b};
}

std::vector<ColorPair> corrections(int count) {
    std::vector<ColorPair> out;
    double weight = 1;
    for (const PixelPair& pixel : picture_pairs([](RgbD c) { return c; }, count)) {
        weight = weight < 3 ? weight + 0.1 : 1;
        out.push_back({to_double(pixel.before), correction_at(to_double(pixel.before)), weight});
    }
    return out;
}

// The normal equations as they are written, by Gauss's elimination.
std::vector<double> plainly(const std::vector<ColorPair>& pairs, int size, double smoothness,
                            std::size_t channel) {
    const int n = size * size * size;
    std::vector<std::vector<double>> a(static_cast<std::size_t>(n),
                                       std::vector<double>(static_cast<std::size_t>(n) + 1));
    const auto cell = [&](std::size_t i, std::size_t k) -> double& { return a[i][k]; };
    for (const ColorPair& pair : pairs) {
        const NodeWeights w =
            node_weights(Interpolation::tetrahedral, size, (size - 1) * pair.before);
        for (std::size_t i = 0; i < w.count; ++i) {
            for (std::size_t k = 0; k < w.count; ++k) {
                cell(w.node[i], w.node[k]) += pair.weight * w.weight[i] * w.weight[k];
            }
            a[w.node[i]].back() += pair.weight * w.weight[i] * pair.after[channel];
        }
    }
    for (int i = 0; i < n; ++i) {
        cell(static_cast<std::size_t>(i), static_cast<std::size_t>(i)) += 1e-5;
        for (const int step : {1, size, size * size}) {
            const int place = i / step % size;
            if (place + 2 < size) {
                const std::array<int, 3> nodes{i, i + step, i + 2 * step};
                const std::array<double, 3> d{1, -2, 1};
                for (std::size_t p = 0; p < 3; ++p) {
                    for (std::size_t q = 0; q < 3; ++q) {
                        cell(static_cast<std::size_t>(nodes[p]),
                             static_cast<std::size_t>(nodes[q])) +=
                            smoothness * (size - 1) / 32 * d[p] * d[q];
                    }
                }
            }
        }
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t row = 0; row < a.size(); ++row) {
            const double factor = row == i ? 0 : a[row][i] / a[i][i];
            for (std::size_t k = i; factor != 0 && k < a[row].size(); ++k) {
                a[row][k] -= factor * a[i][k];
            }
        }
    }
    std::vector<double> out;
    for (std::size_t i = 0; i < a.size(); ++i) {
        out.push_back(a[i].back() / a[i][i]);
    }
    return out;
}

TEST(ResidualLattice, is_the_solution_of_its_normal_equations) {
    const std::vector<ColorPair> pairs = corrections(400);
    for (const int size : {2, 3, 6}) {
        const ResidualLattice found = residual_lattice(pairs, size, {.precision = 1e-9});
        for (std::size_t c = 0; c < 3; ++c) {
            const std::vector<double> wanted = plainly(pairs, size, 0.1, c);
            ASSERT_EQ(found.nodes.size(), wanted.size());
            for (std::size_t k = 0; k < wanted.size(); ++k) {
                EXPECT_NEAR(found.nodes[k][c], wanted[k], 1e-6) << size << ' ' << k;
            }
        }
    }
}

TEST(ResidualLattice, is_read_as_what_was_wanted_where_pixels_are) {
    Lut lut;
    lut.cube = identity_cube(33);
    const std::vector<ColorPair> pairs = corrections(20000);
    const ResidualLattice found = residual_lattice(pairs, 33, {});
    for (std::size_t k = 0; k < found.nodes.size(); ++k) {
        lut.cube->nodes[k] = to_float(found.nodes[k]);
    }
    double most = 0;
    for (const ColorPair& pair : pairs) {
        most = std::max(most, largest_magnitude(evaluate_exact(lut, pair.before) - pair.after));
    }
    // Of a tenth at most, which bends within a cell.
    EXPECT_LT(most, 0.5 / 255);
}

// Of a line that codes end: what goes beyond them is the line's, and what they said is kept.
TEST(ResidualLattice, goes_beyond_what_was_clipped_and_bends_at_no_end_of_the_codes) {
    std::vector<ColorPair> pairs = corrections(20000);
    for (ColorPair& pair : pairs) {
        const double line = 1.6 * pair.before.g - 0.3;
        pair.after = {saturate(line), saturate(line), saturate(line)};
        if (line > 1) {
            pair.clipped = {1, 1, 1};
        } else if (line < 0) {
            pair.clipped = {-1, -1, -1};
        }
    }
    const auto worst = [&](const std::vector<ColorPair>& learnt) {
        Lut lut;
        lut.cube = identity_cube(9);
        const ResidualLattice found = residual_lattice(learnt, 9, {});
        for (std::size_t k = 0; k < found.nodes.size(); ++k) {
            lut.cube->nodes[k] = to_float(found.nodes[k]);
        }
        double most = 0;
        for (const ColorPair& pair : pairs) {
            most = std::max(
                most, largest_magnitude(saturate(evaluate_exact(lut, pair.before)) - pair.after));
        }
        return most;
    };
    std::vector<ColorPair> as_values = pairs;
    for (ColorPair& pair : as_values) {
        pair.clipped = {};
    }
    // What keeps it from going anywhere where nothing says how far costs the rest of it.
    EXPECT_LT(worst(pairs), 0.6 * worst(as_values));
}

// A kink at a node, which squares would round off over its neighbours.
TEST(ResidualLattice, keeps_a_kink_where_it_looks_for_kinks) {
    std::vector<ColorPair> pairs = corrections(600);
    const auto kinked = [](double x) { return std::max(0.0, 4 * (x - 0.5)); };
    for (ColorPair& pair : pairs) {
        const double y = kinked(pair.before.g);
        pair.after = {y, y, y};
        pair.weight = 1e-2;
    }
    const auto off = [&](double kink) {
        const ResidualLattice found = residual_lattice(pairs, 17, {.kink = kink});
        double sum = 0;
        for (int i = 4; i < 13; ++i) {
            sum += std::abs(found.nodes[static_cast<std::size_t>(i * (1 + 17 + 17 * 17))].g -
                            kinked(i / 16.0));
        }
        return sum / 9;
    };
    EXPECT_LT(off(1e-3), 0.3 * off(0));
}

TEST(ResidualLattice, starts_anywhere_and_ends_at_the_same) {
    const std::vector<ColorPair> pairs = corrections(2000);
    const ResidualLattice found = residual_lattice(pairs, 9, {.precision = 1e-8});
    std::vector<RgbD> start(found.nodes.size(), RgbD{0.5, -0.2, 0.1});
    const ResidualLattice again = residual_lattice(pairs, 9, {.precision = 1e-8, .start = start});
    for (std::size_t k = 0; k < found.nodes.size(); ++k) {
        EXPECT_LT(largest_magnitude(again.nodes[k] - found.nodes[k]), 1e-4) << k;
    }
}

TEST(ResidualLattice, is_nothing_where_nothing_is_wanted_and_of_every_size) {
    const std::vector<ColorPair> zero{{{0.2, 0.3, 0.4}, {0, 0, 0}, 5}};
    for (const int size : {2, 5, 32, 33}) {
        const ResidualLattice found = residual_lattice(zero, size, {});
        ASSERT_EQ(found.nodes.size(), static_cast<std::size_t>(size * size * size));
        for (const RgbD& node : found.nodes) {
            EXPECT_EQ(largest_magnitude(node), 0);
        }
    }
    EXPECT_EQ(residual_lattice({}, 4, {}).nodes.size(), 64U);
    EXPECT_THROW(residual_lattice(zero, 1, {}), Error);
}

} // namespace
} // namespace lutlib
