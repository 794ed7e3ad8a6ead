#include "lutlib/resample/invert_closely.h"

#include "lutlib/color/difference.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/resample/invert_shaper.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

Lut cube_look(Lut3D cube) {
    Lut out;
    out.cube = std::move(cube);
    return out;
}

// Invertible, and nearly flat beside white: the inverse is steep there.
RgbD with_shoulder(RgbD c) {
    const auto bend = [](double x) { return (1 - std::exp(-3 * x)) / (1 - std::exp(-3.0)); };
    return {bend(c.r), bend(c.g), bend(c.b)};
}

// Of look and inverse in turn, over colours that no lattice is in step with.
double p99_of_round_trip(const Lut& look, const Lut& inverse) {
    std::vector<double> errors;
    for (const Rgb& in : sample_colors(2, {.neutral = 0, .random = 5000, .lattice = false})) {
        const RgbD out = evaluate_exact(look, to_double(in));
        errors.push_back(delta_e_2000(evaluate_exact(inverse, out), to_double(in)));
    }
    return error_stats(std::move(errors)).p99;
}

TEST(InvertClosely, takes_a_finer_lattice_where_the_looks_own_size_is_too_coarse_for_the_inverse) {
    constexpr RoundTripAim aim{.p99 = 2};
    const Lut look = cube_look(sampled(with_shoulder, 5));
    EXPECT_GT(p99_of_round_trip(look, invert(look).lut), aim.p99);
    const ClosestInversion out = invert_closely(look, {}, srgb(), aim);
    EXPECT_TRUE(out.kept);
    EXPECT_LE(p99_of_round_trip(look, out.inversion.lut), 1.02 * aim.p99); // other colours
    ASSERT_GE(out.attempts.size(), 2U);
    EXPECT_EQ(out.attempts.front().size, 5);
    EXPECT_EQ(out.attempts.back().size, out.inversion.lut.cube->size);
    for (std::size_t i = 0; i + 1 < out.attempts.size(); ++i) {
        EXPECT_GT(out.attempts[i].p99, aim.p99);
    }
}

TEST(InvertClosely, keeps_the_looks_own_size_where_that_is_fine_enough) {
    const Lut look = cube_look(sampled([](RgbD c) { return c * 0.9 + RgbD{.05, .02, .05}; }, 5));
    const ClosestInversion out = invert_closely(look, {}, srgb());
    EXPECT_TRUE(out.kept);
    EXPECT_EQ(out.inversion.lut.cube->size, 5);
    EXPECT_EQ(out.attempts.size(), 1U);
}

TEST(InvertClosely, takes_the_size_that_is_asked_for) {
    const Lut look = cube_look(sampled(with_shoulder, 9));
    const ClosestInversion out = invert_closely(look, {.size = 7}, srgb());
    EXPECT_EQ(out.inversion.lut.cube->size, 7);
    EXPECT_TRUE(out.attempts.empty());
}

TEST(InvertClosely, says_that_no_size_keeps_the_aim_and_takes_the_nearest) {
    const RoundTripAim aim{.p99 = 0.01, .largest = 12, .furthest = 12};
    const Lut look = cube_look(sampled(with_shoulder, 5));
    const ClosestInversion out = invert_closely(look, {}, srgb(), aim);
    EXPECT_FALSE(out.kept);
    ASSERT_EQ(out.attempts.size(), 4U);
    EXPECT_EQ(out.attempts.back().size, aim.largest);
    const auto nearest =
        std::min_element(out.attempts.begin(), out.attempts.end(),
                         [](const auto& a, const auto& b) { return a.p99 < b.p99; });
    EXPECT_EQ(nearest->size, out.inversion.lut.cube->size);
    EXPECT_GT(nearest->p99, aim.p99);
}

// Outputs crowd towards white, as with a soft clip.
TEST(InvertClosely, puts_its_nodes_where_the_looks_outputs_crowd_if_it_may) {
    const Lut look = cube_look(sampled(
        [](RgbD c) {
            const double y = test_luma(c);
            return with_shoulder({0.8 * c.r + 0.2 * y, 0.8 * c.g + 0.2 * y, 0.8 * c.b + 0.2 * y});
        },
        9));
    constexpr RoundTripAim aim{.p99 = 0.01, .largest = 9, .furthest = 9};
    const ClosestInversion out = invert_closely(look, {}, srgb(), aim);
    ASSERT_EQ(out.attempts.size(), 2U);
    ASSERT_TRUE(out.inversion.lut.shaper && out.inversion.lut.cube);
    const Lut plain = invert(look, {.size = 9}).lut;
    EXPECT_LT(p99_of_round_trip(look, out.inversion.lut), 0.8 * p99_of_round_trip(look, plain));
    const ClosestInversion without = invert_closely(look, {.shaper = "none"}, srgb(), aim);
    EXPECT_FALSE(without.inversion.lut.shaper);
}

TEST(InvertClosely, goes_beyond_its_usual_sizes_only_where_that_promises_to_do) {
    const Lut look = cube_look(sampled(with_shoulder, 5));
    const ClosestInversion least =
        invert_closely(look, {.shaper = "none"}, srgb(), {.p99 = 0, .largest = 9, .furthest = 17});
    EXPECT_EQ(least.attempts.back().size, 9);
    const double at_9 = least.attempts.back().p99;
    const ClosestInversion more = invert_closely(look, {.shaper = "none"}, srgb(),
                                                 {.p99 = 0.9 * at_9, .largest = 9, .furthest = 17});
    EXPECT_EQ(more.attempts.back().size, 17);
    EXPECT_TRUE(more.kept);
}

TEST(InvertClosely, of_a_constant_has_nothing_to_choose_by) {
    const Lut look = cube_look(sampled([](RgbD) { return RgbD{.5, .4, .3}; }, 3));
    const ClosestInversion out = invert_closely(look, {}, srgb());
    EXPECT_TRUE(out.attempts.empty());
    EXPECT_EQ(out.inversion.lut.cube->size, 3);
}

// Blue turns back at heights that differ from cell to cell: colours that can be undone share the
// inverse's cells with others that cannot, and with nodes that no input gives.
TEST(InvertClosely, lets_no_folded_input_speak_for_what_lies_beside_the_gamut) {
    const Lut look = cube_look(sampled(
        [](RgbD c) {
            const double turn = 0.6 + 0.4 * std::abs(std::sin(6 * c.r + 5 * c.g));
            return RgbD{c.r, c.g, c.b < turn ? c.b : turn - 0.3 * (c.b - turn)};
        },
        17));
    const Inversion inverse = invert(look, {.size = 17});
    EXPECT_GT(inverse.inputs.folded, 0.15);
    const Difference error = compare({}, round_trip(look, inverse.lut), inverse.undoable, srgb());
    EXPECT_LT(error.delta_e_2000.p99, 1.2); // 2.35 where they do
}

} // namespace
} // namespace lutlib
