#include "lutlib/bake/budget.h"

#include "lutlib/bake/bake.h"
#include "tests/lutlib/looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// Bends in every cell, as a real look's rounded nodes do.
Lut rough_look(int size) {
    Lut out;
    out.cube = sampled(
        [](RgbD c) {
            const auto bend = [](double x, double y) {
                return saturate(x + 0.08 * std::sin(23 * x + 9 * y));
            };
            return RgbD{bend(c.r, c.g), bend(c.g, c.b), bend(c.b, c.r)};
        },
        size);
    return out;
}

double largest(const Transform& look, const Engine& engine, int size, const Breaks& breaks) {
    const Bake baked = bake(look, engine, size, 8);
    return measure_lookup(baked.picture, engine, size, look, breaks, srgb(), {.even = 1000})
        .delta_e_2000.max;
}

TEST(Budget, takes_the_smallest_of_all_sizes_by_the_whole_union_grid) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    const Engine& engine = *engine_named("piccolo");
    const Lut lut = rough_look(7);
    const Transform look = Transform::of(lut);
    const Budget budget{.most = 12,
                        .size = {},
                        .bits = {},
                        .fit = false,
                        .breaks = breaks_of(lut),
                        .nodes = lut.cube->size};
    const BudgetBake found = bake_within(look, engine, budget);
    ASSERT_TRUE(found.kept);
    EXPECT_LE(found.error.delta_e_2000.max, budget.most);
    for (int size = 2; size < found.filled.bake.size; ++size) {
        EXPECT_GT(largest(look, engine, size, budget.breaks), budget.most) << size;
    }
}

TEST(Budget, names_what_none_of_the_sizes_stays_within) {
    const Engine& engine = *engine_named("unreal");
    const Lut lut = rough_look(7);
    const Budget budget{
        .most = 0.1, .size = {}, .bits = {}, .fit = false, .breaks = breaks_of(lut)};
    const BudgetBake found = bake_within(Transform::of(lut), engine, budget);
    EXPECT_FALSE(found.kept);
    EXPECT_EQ(found.filled.bake.size, 16);
    EXPECT_DOUBLE_EQ(found.largest, found.error.delta_e_2000.max);
    EXPECT_GT(found.largest, 0.1);
}

// Whose error of 1.005 lies in the middle of one of 97^3 cells, where no rounding comes above 0.9.
TEST(Budget, is_broken_by_a_single_wrong_node) {
    Lut lut;
    lut.cube = identity_cube(33);
    Rgb& wrong = lut.cube->nodes[lut.cube->index(0, 1, 1)];
    wrong = wrong + Rgb{0, -0.017F, 0.033F};
    const Budget budget{
        .most = 0.95, .size = 97, .bits = 8, .fit = false, .breaks = breaks_of(lut)};
    EXPECT_FALSE(bake_within(Transform::of(lut), *engine_named("piccolo"), budget).kept);
}

TEST(Budget, tries_every_size_that_a_strip_may_have_and_multiples_of_the_looks_cells) {
    const auto has = [](const std::vector<int>& sizes, int size) {
        return std::find(sizes.begin(), sizes.end(), size) != sizes.end();
    };
    const std::vector<int> strip = sizes_tried(*engine_named("piccolo"), 32);
    EXPECT_EQ(strip.size(), 127U); // 2 to 128, whose picture is 16384 wide
    const std::vector<int> in_rows = sizes_tried(*engine_named("ocio"), 32);
    EXPECT_TRUE(has(in_rows, 67));
    EXPECT_TRUE(has(in_rows, 7 * 31 + 1));
    EXPECT_FALSE(has(in_rows, 7 * 31));
    const std::vector<int> unity = sizes_tried(*engine_named("unity"), 17);
    EXPECT_EQ(unity.front(), 16);
    EXPECT_EQ(unity.back(), 65);
}

// Unity reads 32 nodes unless its asset says another size.
TEST(Budget, takes_a_size_that_needs_a_setting_only_where_no_usual_one_keeps_the_promise) {
    Lut lut;
    lut.cube = sampled([](RgbD c) { return RgbD{0.5 + 0.4 * std::sin(20 * c.r), c.g, c.b}; }, 17);
    const Engine& unity = *engine_named("unity");
    const auto size_within = [&](double most) {
        const Budget budget{
            .most = most, .size = {}, .bits = {}, .fit = false, .breaks = breaks_of(lut)};
        const BudgetBake found = bake_within(Transform::of(lut), unity, budget);
        EXPECT_TRUE(found.kept) << most;
        return found.filled.bake.size;
    };
    const Budget usual{.most = 1e-9, .size = 32, .bits = 8, .fit = false, .breaks = breaks_of(lut)};
    const double of_32 = bake_within(Transform::of(lut), unity, usual).largest;
    EXPECT_EQ(size_within(1.01 * of_32), 32);
    EXPECT_EQ(size_within(0.9 * of_32), 17); // the look's own nodes
}

// Fits lower the largest error by up to 1.6 times.
TEST(Budget, fits_where_point_samples_break_the_promise_by_more_than_a_fifth) {
    const Engine& engine = *engine_named("piccolo");
    Lut lut;
    lut.cube = sampled(
        [](RgbD c) {
            return RgbD{std::pow(c.r, 0.6), std::pow(c.g, 0.8), std::pow(c.b, 1.5)};
        },
        17);
    const Transform look = Transform::of(lut);
    const double most = largest(look, engine, 7, breaks_of(lut)) / 1.22;
    const Budget budget{.most = most, .size = 7, .bits = 8, .breaks = breaks_of(lut)};
    EXPECT_TRUE(bake_within(look, engine, budget).kept);
}

TEST(Budget, judges_a_pq_output_as_pq) {
    const Engine& engine = *engine_named("ocio");
    const Transform look = Transform::each([](RgbD c) {
        const auto s = [](double x) { return x * x * (3 - 2 * x); };
        return RgbD{s(c.r), s(c.g), s(c.b)};
    });
    const Viewing pq{require_encoding("pq")};
    constexpr double most = 8;
    const auto found_for = [&](const Viewing& viewing) {
        return bake_within(look, engine,
                           {.most = most,
                            .size = {},
                            .bits = 16,
                            .fit = false,
                            .metric = Metric::delta_e_itp,
                            .viewing = viewing});
    };
    const BudgetBake as_pq = found_for(pq), as_srgb = found_for(srgb());
    ASSERT_TRUE(as_pq.kept);
    EXPECT_LE(as_pq.error.delta_e_itp.max, most);
    EXPECT_NE(as_pq.filled.bake.size, as_srgb.filled.bake.size);
    EXPECT_TRUE(as_pq.error.delta_e_itp.largest_seen);
}

TEST(Fit, makes_neither_the_largest_nor_the_mean_of_either_measure_grow) {
    const Engine& engine = *engine_named("piccolo");
    const Lut lut = rough_look(17);
    const Transform look = Transform::of(lut);
    const Breaks breaks = breaks_of(lut);
    const FilledBake fit = bake_fitted(look, engine, 12, 8, {breaks, srgb()});
    ASSERT_TRUE(fit.fitted);
    const auto measured = [&](const Bake& baked) {
        return measure_lookup(baked.picture, engine, 12, look, breaks, srgb(), {.even = 30'000});
    };
    const Difference now = measured(fit.bake), before = measured(bake(look, engine, 12, 8));
    EXPECT_LT(now.delta_e_2000.mean, 0.9 * before.delta_e_2000.mean);
    EXPECT_LT(now.absolute.mean, before.absolute.mean);
    EXPECT_LE(now.delta_e_2000.max, 1.0005 * before.delta_e_2000.max);
    EXPECT_LE(now.absolute.max, 1.0005 * before.absolute.max);
    EXPECT_LE(fit.tint, 1.05 * fit.tint_of_point_samples + 1e-3);
}

} // namespace
} // namespace lutlib
