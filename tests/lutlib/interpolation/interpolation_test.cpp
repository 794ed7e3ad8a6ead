#include "lutlib/interpolation/interpolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lutlib {
namespace {

Lut3D random_cube(int size, const Domain& domain, unsigned seed) {
    Lut3D cube = identity_cube(size, domain);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(-0.2F, 1.2F);
    for (Rgb& node : cube.nodes) {
        node = {value(random), value(random), value(random)};
    }
    return cube;
}

class EveryInterpolation : public testing::TestWithParam<InterpolationInfo> {};
INSTANTIATE_TEST_SUITE_P(Interpolation, EveryInterpolation,
                         testing::ValuesIn(interpolations().begin(), interpolations().end()),
                         [](const auto& row) { return std::string(row.param.name); });

class EveryContinuousInterpolation : public testing::TestWithParam<Interpolation> {};
INSTANTIATE_TEST_SUITE_P(Interpolation, EveryContinuousInterpolation,
                         testing::Values(Interpolation::trilinear, Interpolation::tetrahedral),
                         [](const auto& row) { return std::string(name_of(row.param)); });

TEST_P(EveryContinuousInterpolation, float_path_is_within_5e_6_of_the_double_oracle) {
    const Lut3D cube = random_cube(17, {{-1, 0, 0.25F}, {1, 4, 0.5F}}, 1);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(-0.1F, 1.1F);
    for (int i = 0; i < 100000; ++i) {
        const Rgb in{unit(random) * 2 - 1, unit(random) * 4, unit(random) * 0.25F + 0.25F};
        const Rgb fast = evaluate(cube, in, GetParam());
        const RgbD exact = evaluate_exact(cube, to_double(in), GetParam());
        for (std::size_t c = 0; c < 3; ++c) {
            // A cell's steepest slope, 1.4, times the coordinate's rounding, 16 * 2^-24 * 2.
            ASSERT_NEAR(fast[c], exact[c], 5e-6);
        }
    }
}

TEST_P(EveryInterpolation, returns_nodes_exactly_at_their_positions) {
    const Lut3D cube = random_cube(5, {}, 3);
    for (int b = 0; b < 5; ++b) {
        for (int g = 0; g < 5; ++g) {
            for (int r = 0; r < 5; ++r) {
                const Rgb in = to_float(node_position(cube, r, g, b));
                EXPECT_EQ(evaluate(cube, in, GetParam().kind), cube.at(r, g, b));
            }
        }
    }
}

TEST_P(EveryInterpolation, clamps_to_the_domain_and_reads_nan_as_its_minimum) {
    const Lut3D cube = random_cube(4, {{-1, 0, 0.25F}, {1, 4, 0.5F}}, 4);
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(evaluate(cube, {nan, nan, nan}, GetParam().kind), cube.at(0, 0, 0));
    EXPECT_EQ(evaluate(cube, {inf, -inf, nan}, GetParam().kind), cube.at(3, 0, 0));
    EXPECT_EQ(evaluate(cube, {-9, 99, inf}, GetParam().kind), cube.at(0, 3, 3));
    EXPECT_EQ(evaluate_exact(cube, {INFINITY, -INFINITY, NAN}, GetParam().kind),
              to_double(cube.at(3, 0, 0)));
}

TEST_P(EveryInterpolation, stays_finite_on_the_largest_finite_values) {
    Lut3D cube = identity_cube(2);
    for (std::size_t i = 0; i < cube.nodes.size(); ++i) {
        const float v = (i % 2 ? 1.0F : -1.0F) * std::numeric_limits<float>::max();
        cube.nodes[i] = {v, v, v};
    }
    const Rgb out = evaluate(cube, {0.3F, 0.5F, 0.7F}, GetParam().kind);
    EXPECT_TRUE(std::isfinite(out.r) && std::isfinite(out.g) && std::isfinite(out.b));
}

TEST_P(EveryInterpolation, is_the_sum_of_its_node_weights) {
    std::mt19937 random(5);
    for (const int size : {2, 5, 17}) {
        const auto last = static_cast<float>(size - 1);
        const Lut3D cube = random_cube(size, {{0, 0, 0}, {last, last, last}}, 6);
        std::uniform_real_distribution<double> place(-0.5, size - 0.5);
        for (int i = 0; i < 2000; ++i) {
            // Some on nodes and in planes where two tetrahedra meet.
            RgbD at{place(random), place(random), place(random)};
            at.r = i % 3 == 0 ? std::round(at.r) : at.r;
            at.g = i % 5 == 0 ? at.r : at.g;
            const NodeWeights w = node_weights(GetParam().kind, size, at);
            RgbD sum;
            for (std::size_t k = 0; k < w.count; ++k) {
                sum = sum + w.weight[k] * to_double(cube.nodes[w.node[k]]);
            }
            ASSERT_LT(largest_magnitude(sum - evaluate_exact(cube, at, GetParam().kind)), 1e-14);
        }
    }
}

TEST(Tetrahedral, is_exact_on_the_neutral_axis_of_a_look_that_is_linear_there) {
    Lut3D cube = identity_cube(16);
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) {
            if (i != j) {
                cube.at(i, j, j) = {9, 9, 9};
            }
        }
    }
    for (int code = 0; code < 256; ++code) {
        const float v = static_cast<float>(code) / 255;
        EXPECT_NEAR(evaluate(cube, {v, v, v}, Interpolation::tetrahedral).g, v, 2e-7);
    }
}

TEST(Curve, interpolates_linearly_over_its_own_domain_per_channel) {
    Lut1D curve{{{-2, 1, 0}, {2, 2, 1}}, {{-1, -2, -3}, {0, .1F, .2F}, {1, 2.1F, 3.2F}}};
    const Rgb out = evaluate(curve, {-1, 1.75F, 2});
    EXPECT_FLOAT_EQ(out.r, -0.5F);
    EXPECT_FLOAT_EQ(out.g, 1.1F);
    EXPECT_FLOAT_EQ(out.b, 3.2F);
}

} // namespace
} // namespace lutlib
