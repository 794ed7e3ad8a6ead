// What coarser lattices make of a look, against a search that shares no code with it.
#include "lutlib/health/health.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/metrics/samples.h"
#include "tests/lutlib/looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lutlib {
namespace {

Lut look(RgbD (*f)(RgbD), int size) {
    Lut lut;
    lut.cube = sampled(f, size);
    return lut;
}

// The error of a lattice of `nodes` a side that holds the look's values, against the look.
double measured_error(const Lut& lut, int nodes) {
    Lut coarse;
    coarse.cube = identity_cube(nodes, lut.domain());
    for (int b = 0; b < nodes; ++b) {
        for (int g = 0; g < nodes; ++g) {
            for (int r = 0; r < nodes; ++r) {
                coarse.cube->at(r, g, b) =
                    to_float(evaluate_exact(lut, node_position(*coarse.cube, r, g, b)));
            }
        }
    }
    double most = 0;
    // Where neither of the two bends, their difference is linear: it is largest at the nodes of the
    // look, which are stored, or where the coarse lattice bends, which the other colours find.
    if (lut.cube && !lut.shaper) {
        for (std::size_t k = 0; k < lut.cube->nodes.size(); ++k) {
            const auto n = static_cast<std::size_t>(lut.cube->size);
            const RgbD in = node_position(*lut.cube, static_cast<int>(k % n),
                                          static_cast<int>(k / n % n), static_cast<int>(k / n / n));
            most = std::max(most, largest_magnitude(to_double(lut.cube->nodes[k]) -
                                                    evaluate_exact(coarse, in)));
        }
    }
    const SampleCounts counts{.random = 20000, .lattice = lut.shaper.has_value()};
    for (const Rgb& unit : sample_colors(lut.cube ? lut.cube->size : 65, counts)) {
        RgbD in;
        for (std::size_t c = 0; c < 3; ++c) {
            in[c] =
                std::lerp(static_cast<double>(lut.domain().min[c]),
                          static_cast<double>(lut.domain().max[c]), static_cast<double>(unit[c]));
        }
        most =
            std::max(most, largest_magnitude(evaluate_exact(lut, in) - evaluate_exact(coarse, in)));
    }
    return most;
}

const std::vector<TestLook>& smooth_looks() {
    static const std::vector<TestLook> looks{
        {"contrast",
         [](RgbD c) {
             const auto s = [](double x) { return x * x * (3 - 2 * x); };
             return RgbD{s(c.r), s(c.g), s(c.b)};
         }},
        {"shoulder",
         [](RgbD c) {
             const auto s = [](double x) { return 1 / (1 + std::exp(-10 * (x - 0.5))); };
             return RgbD{s(c.r), s(c.g), s(c.b)};
         }},
        {"saturation_by_luma",
         [](RgbD c) {
             const double y = test_luma(c), k = 0.5 + y;
             return RgbD{y + k * (c.r - y), y + k * (c.g - y), y + k * (c.b - y)};
         }},
        {"waves",
         [](RgbD c) {
             return RgbD{c.r + 0.05 * std::sin(6 * c.g), c.g + 0.04 * std::sin(5 * (c.b + c.r)),
                         c.b * (0.8 + 0.2 * std::cos(4 * c.r))};
         }},
        {"film",
         [](RgbD c) {
             const auto f = [](double x) { return (1 + 0.4) * x / (x + 0.4); };
             return RgbD{f(0.9 * c.r + 0.1 * c.g), f(c.g), f(0.8 * c.b + 0.2 * c.g)};
         }},
    };
    return looks;
}

TEST(LatticeError, is_what_a_search_of_its_own_finds_at_the_place_that_is_said) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    const std::vector<int> sizes =
        support::is_sanitized ? std::vector<int>{9} : std::vector<int>{17, 33};
    for (const TestLook& smooth : smooth_looks()) {
        for (const int size : sizes) {
            const Lut lut = look(smooth.f, size);
            for (const LatticeError& e : examine(lut).lattices) {
                ASSERT_TRUE(e.measured);
                EXPECT_GE(e.code.max, 0.999 * measured_error(lut, e.nodes) - 1e-6)
                    << smooth.name << " of " << size << " at " << e.nodes;
                Lut lattice;
                lattice.cube = sampled([](RgbD c) { return c; }, e.nodes);
                for (Rgb& node : lattice.cube->nodes) {
                    node = to_float(evaluate_exact(lut, to_double(node)));
                }
                const RgbD in = to_double(e.in);
                EXPECT_NEAR(
                    e.code.max,
                    largest_magnitude(evaluate_exact(lut, in) - evaluate_exact(lattice, in)), 1e-6);
            }
        }
    }
}

TEST(LatticeError, of_a_recipe_is_against_the_recipe_and_not_its_table) {
    const auto bend = [](RgbD c) { return RgbD{std::cbrt(c.r), std::cbrt(c.g), std::cbrt(c.b)}; };
    const Lut table = look(bend, 33);
    EXPECT_LT(examine(table).lattices[1].code.max, 1e-6);
    const Health h = examine(table, {.exact = Transform::each(bend)});
    // In the first cell the cube root lies above its chord by (2 / sqrt(27)) of the cell's height.
    EXPECT_NEAR(h.lattices[1].code.max, 2 / std::sqrt(27.0) * std::cbrt(1 / 32.0), 0.003);
}

} // namespace
} // namespace lutlib
