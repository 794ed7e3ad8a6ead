#include "lutlib/curve.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace lutlib {
namespace {

TEST(Curve, passes_through_its_knots_in_whatever_order_they_come) {
    const Knots knots{{0.7, 0.9}, {0, 0.1}, {1, 0.95}, {0.2, 0.4}};
    const Curve curve = Curve::open(knots);
    for (const Knot& k : knots) {
        EXPECT_NEAR(curve(k.x), k.y, 1e-15);
    }
}

TEST(Curve, is_flat_outside_its_knots) {
    const Curve curve = Curve::open({{0.25, 0.1}, {0.75, 0.8}});
    EXPECT_EQ(curve(0.2), 0.1);
    EXPECT_EQ(curve(-1e300), 0.1);
    EXPECT_EQ(curve(0.8), 0.8);
    EXPECT_EQ(curve(1e300), 0.8);
    EXPECT_EQ(curve(std::numeric_limits<double>::quiet_NaN()), 0.1);
}

TEST(Curve, through_two_knots_is_their_straight_line) {
    const Curve curve = Curve::open({{0, 0}, {1, 2}});
    for (double x = 0; x <= 1; x += 0.01) {
        EXPECT_NEAR(curve(x), 2 * x, 1e-15);
    }
}

TEST(Curve, reproduces_the_monotone_data_set_of_fritsch_and_carlson) {
    // Their table 1, "RPN 14": flat, then steep, then nearly flat. Ordinary splines overshoot it.
    const Knots rpn14{{7.99, 0},       {8.09, 2.76429e-5}, {8.19, 4.37498e-2},
                      {8.7, 0.169183}, {9.2, 0.469428},    {10, 0.943740},
                      {12, 0.998636},  {15, 0.999919},     {20, 0.999994}};
    const Curve curve = Curve::open(rpn14);
    double before = 0;
    for (double x = 7.9; x < 20.1; x += 0.001) {
        ASSERT_GE(curve(x), before);
        ASSERT_LE(curve(x), 0.999994);
        before = curve(x);
    }
}

TEST(Curve, stays_between_neighbouring_knots_and_rises_where_they_rise) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 200; ++round) {
        Knots knots;
        for (int i = 0; i < 2 + round % 9; ++i) {
            knots.push_back({unit(random), unit(random)});
        }
        const Curve curve = Curve::open(knots);
        std::sort(knots.begin(), knots.end(), [](auto a, auto b) { return a.x < b.x; });
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            const auto [low, high] = std::minmax(knots[i].y, knots[i + 1].y);
            double before = knots[i].y;
            for (int j = 1; j < 50; ++j) {
                const double y = curve(std::lerp(knots[i].x, knots[i + 1].x, j / 50.0));
                ASSERT_GE(y, low - 1e-12);
                ASSERT_LE(y, high + 1e-12);
                ASSERT_GE((y - before) * (knots[i + 1].y - knots[i].y), -1e-12);
                before = y;
            }
        }
    }
}

TEST(Curve, has_a_continuous_derivative_inside) {
    const Curve curve = Curve::open({{0, 0}, {0.3, 0.1}, {0.5, 0.7}, {0.8, 0.75}, {1, 1}});
    constexpr double h = 1e-6;
    for (const double x : {0.3, 0.5, 0.8}) {
        const double before = (curve(x) - curve(x - h)) / h, after = (curve(x + h) - curve(x)) / h;
        EXPECT_NEAR(before, after, 1e-3); // second derivatives here are below 100
    }
}

TEST(Curve, merges_coincident_knots_and_bears_crowded_ones) {
    EXPECT_EQ(Curve::open({{0.5, 1}, {0.5, 3}})(0.2), 2);
    EXPECT_EQ(Curve::open({{3, 7}})(-5), 7);
    EXPECT_EQ(Curve::open({}, 1)(0.4), 1);
    const Curve crowded = Curve::open({{0, 0}, {0.5, 0.2}, {0.5 + 1e-8, 0.8}, {1, 1}});
    for (double x = -0.1; x < 1.1; x += 0.001) {
        ASSERT_GE(crowded(x), 0);
        ASSERT_LE(crowded(x), 1);
    }
    EXPECT_NEAR(crowded(0.5 + 5e-9), 0.5, 0.05);
}

TEST(Curve, refuses_knots_that_are_not_finite) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Curve::open({{nan, 0}, {1, 1}}), Error);
    EXPECT_THROW(Curve::open({{0, INFINITY}, {1, 1}}), Error);
    EXPECT_THROW(Curve::periodic({{0, 1e10}}, 360), Error);
}

TEST(PeriodicCurve, has_no_seam_in_value_or_slope) {
    const Curve curve = Curve::periodic({{20, 1}, {120, 1.4}, {240, 0.8}, {330, 0.9}}, 360);
    constexpr double h = 1e-5;
    EXPECT_NEAR(curve(0), curve(360), 1e-15);
    EXPECT_NEAR(curve(-90), curve(270), 1e-15);
    EXPECT_NEAR(curve(360 - h), curve(h), 1e-5);
    for (const double x : {0.0, 20.0, 330.0, 360.0}) {
        const double before = (curve(x) - curve(x - h)) / h, after = (curve(x + h) - curve(x)) / h;
        EXPECT_NEAR(before, after, 1e-5);
    }
}

TEST(PeriodicCurve, takes_a_full_turn_and_zero_for_one_place) {
    const Curve curve = Curve::periodic({{0, 1}, {180, 2}, {360, 1}}, 360);
    EXPECT_EQ(curve(0), 1);
    EXPECT_EQ(curve(360), 1);
    EXPECT_EQ(curve(180), 2);
    EXPECT_EQ(Curve::periodic({{0, 1}, {360, 3}}, 360)(90), 2);
    EXPECT_EQ(Curve::periodic({{77, 5}}, 360)(-1), 5);
}

TEST(PeriodicCurve, is_the_same_when_its_knots_are_named_a_turn_later) {
    const Curve a = Curve::periodic({{10, 1}, {100, 3}, {200, 0}}, 360);
    const Curve b = Curve::periodic({{370, 1}, {-260, 3}, {920, 0}}, 360);
    for (double x = -400; x < 800; x += 7) {
        ASSERT_NEAR(a(x), b(x), 1e-12);
    }
}

} // namespace
} // namespace lutlib
