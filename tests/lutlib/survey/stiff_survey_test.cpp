#include "lutlib/survey/stiff_survey.h"

#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

StiffSettings quick() {
    StiffSettings out;
    out.sizes = {8, 12, 16, 24, 33};
    out.phases = 8;
    out.colors = 400;
    out.largest_fitted = 8;
    out.whole_phases = 2;
    return out;
}

const StiffSurvey& surveyed() {
    static const StiffSurvey survey = survey_stiff_suite(
        support::is_thorough() ? StiffSettings{} : quick(), [](double, const std::string&) {});
    return survey;
}

const StiffCurve& curve_of(std::string_view profile, StiffAxis axis, std::string_view method) {
    const auto found =
        std::find_if(surveyed().curves.begin(), surveyed().curves.end(), [&](const StiffCurve& c) {
            return c.profile->name == profile && c.axis == axis && c.method->name == method;
        });
    EXPECT_NE(found, surveyed().curves.end()) << profile << " " << method;
    return *found;
}

TEST(StiffSurvey, finds_the_orders_that_theory_gives_for_linear_interpolation) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    for (const StiffCurve& curve : surveyed().curves) {
        const std::string_view method = curve.method->name;
        if (curve.profile->order < 0 || (method != "trilinear" && method != "tetrahedral")) {
            continue;
        }
        EXPECT_NEAR(curve.largest.value, curve.profile->order, 0.12)
            << curve.profile->name << " " << method << " +- " << curve.largest.interval;
    }
}

TEST(StiffSurvey, finds_first_order_of_the_nearest_node_and_third_of_tricubic_where_all_is_smooth) {
    EXPECT_NEAR(curve_of("smooth", StiffAxis::channel, "nearest").largest.value, 1, 0.1);
    EXPECT_NEAR(curve_of("smooth", StiffAxis::mixed, "nearest").largest.value, 1, 0.1);
    EXPECT_GT(curve_of("smooth", StiffAxis::channel, "tricubic").largest.value, 2.7);
    // A kink is a kink for every one of them.
    EXPECT_NEAR(curve_of("kink", StiffAxis::channel, "tricubic").largest.value, 1, 0.1);
}

TEST(StiffSurvey, finds_no_error_above_the_bound_that_was_known_before) {
    std::size_t bounds = 0;
    for (const StiffCurve& curve : surveyed().curves) {
        for (const StiffPoint& point : curve.points) {
            if (point.bound > 0 && curve.method->storage->bits == 0) {
                ++bounds;
                EXPECT_LE(point.worst.max, 1.001 * point.bound + 2e-6)
                    << curve.profile->name << " " << curve.method->name << " " << point.size;
            }
        }
    }
    EXPECT_GT(bounds, 100U);
}

TEST(StiffSurvey, lets_no_alignment_decide) {
    // A step between two nodes is nearly right for the nearest one, and wrong by 1 for others.
    for (const StiffPoint& point : curve_of("step", StiffAxis::channel, "nearest").points) {
        EXPECT_GT(point.worst.mean, 1.05 * point.average.mean) << point.size;
        EXPECT_GE(point.worst.max, 1);
        EXPECT_LE(point.worst.p99, 1);
    }
}

TEST(StiffSurvey, shows_what_bits_a_shaper_and_a_fit_change) {
    const StiffCurve &floats = curve_of("smooth", StiffAxis::mixed, "tetrahedral"),
                     &eight = curve_of("smooth", StiffAxis::mixed, "8");
    // Of many nodes the rounding remains.
    EXPECT_GT(eight.points.back().worst.max, 0.5 / 255);
    EXPECT_GT(eight.points.back().worst.max, 2 * floats.points.back().worst.max);
    EXPECT_LT(
        curve_of("gamma_2.2", StiffAxis::channel, "shaper").points.front().average.max,
        0.75 * curve_of("gamma_2.2", StiffAxis::channel, "tetrahedral").points.front().average.max);
    EXPECT_LT(curve_of("kink", StiffAxis::mixed, "fitted").points.front().average.mean,
              0.9 * curve_of("kink", StiffAxis::mixed, "tetrahedral").points.front().average.mean);
}

TEST(Slope, has_the_interval_of_a_textbook) {
    // y = 3 x^2 exactly.
    const Slope exact = slope_of({{1, 3}, {2, 12}, {4, 48}}, 0);
    EXPECT_NEAR(exact.value, 2, 1e-12);
    EXPECT_NEAR(exact.interval, 0, 1e-9);
    // Logarithms 0, 1, 2, 3 and 0, 1.1, 1.9, 3.2: slope 1.04, its standard error
    // sqrt(0.042 / 2 / 5) = 0.0648, times Student's 4.303.
    const auto e = [](double x) { return std::exp(x); };
    const Slope rough = slope_of({{1, 1}, {e(1), e(1.1)}, {e(2), e(1.9)}, {e(3), e(3.2)}}, 0);
    EXPECT_NEAR(rough.value, 1.04, 1e-12);
    EXPECT_NEAR(rough.interval, 4.303 * std::sqrt(0.042 / 2 / 5), 1e-3);
    EXPECT_EQ(slope_of({{1, 1}, {2, 0.001}, {3, 1}}, 0.01).points, 2U);
    EXPECT_TRUE(std::isinf(slope_of({{1, 1}}, 0).interval));
}

} // namespace
} // namespace lutlib
