#include "lutlib/color/oklab.h"

#include "lutlib/color/gamut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lutlib {
namespace {

TEST(Oklab, gives_the_published_values_of_the_srgb_primaries) {
    struct Row {
        RgbD linear, lab;
    };
    // CSS Color 4's sample code, to the digits that are usually printed.
    for (const Row& row :
         {Row{{1, 1, 1}, {1, 0, 0}}, Row{{1, 0, 0}, {.62796, .22486, .12585}},
          Row{{0, 1, 0}, {.86644, -.23389, .17950}}, Row{{0, 0, 1}, {.45201, -.03246, -.31153}}}) {
        const RgbD lab = oklab_from_linear(row.linear);
        EXPECT_NEAR(lab.r, row.lab.r, 6e-6);
        EXPECT_NEAR(lab.g, row.lab.g, 6e-6);
        EXPECT_NEAR(lab.b, row.lab.b, 6e-6);
        const RgbD back = linear_from_oklab(lab);
        EXPECT_NEAR(back.r, row.linear.r, 1e-14);
        EXPECT_NEAR(back.g, row.linear.g, 1e-14);
        EXPECT_NEAR(back.b, row.linear.b, 1e-14);
    }
}

TEST(Oklab, leaves_neutrals_of_every_encodings_primaries_without_chroma) {
    for (const Gamut* gamut : gamuts()) {
        const RgbD lab = oklab_from_lms(oklab_cones(gamut->primaries) * RgbD{.18, .18, .18});
        EXPECT_NEAR(std::hypot(lab.g, lab.b), 0, 1e-14) << gamut->name;
    }
}

TEST(HueDial, puts_the_srgb_corners_at_multiples_of_60_degrees) {
    const RgbD corners[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    for (int i = 0; i < 6; ++i) {
        const RgbD lab = oklab_from_linear(corners[i]);
        const double away = dial_hue(lab.g, lab.b) - 60 * i;
        EXPECT_NEAR(std::remainder(away, 360), 0, 1e-9);
        const double angle = std::atan2(lab.b, lab.g) * 180 / std::numbers::pi;
        EXPECT_NEAR(std::remainder(oklab_hue(60 * i) - angle, 360), 0, 1e-9);
    }
}

TEST(HueDial, rises_once_round_the_circle_without_a_seam_or_a_kink) {
    const auto dial = [](double degrees) {
        const double t = degrees * std::numbers::pi / 180;
        return dial_hue(0.1 * std::cos(t), 0.1 * std::sin(t));
    };
    constexpr double step = 0.01;
    double total = 0, slope_before = 0;
    for (int i = 0; i < 36000; ++i) {
        const double rise = std::remainder(dial((i + 1) * step) - dial(i * step), 360);
        ASSERT_GT(rise, 0) << i * step;
        total += rise;
        const double slope = rise / step;
        if (i > 0) {
            ASSERT_NEAR(slope, slope_before, 0.01) << i * step;
        }
        slope_before = slope;
        ASSERT_NEAR(std::remainder(oklab_hue(dial(i * step)) - i * step, 360), 0, 1e-6);
    }
    EXPECT_NEAR(total, 360, 1e-6);
}

// Where a hue is negative by its last bit, adding a turn gives a whole one.
TEST(HueDial, stays_below_a_whole_turn) {
    const auto around = [](double middle, auto&& check) {
        double up = middle, down = middle;
        for (int i = 0; i < 1000; ++i) {
            check(up);
            check(down);
            up = std::nextafter(up, INFINITY);
            down = std::nextafter(down, -INFINITY);
        }
    };
    around(dial_hue(0.1, 0), [](double place) {
        EXPECT_GE(oklab_hue(place), 0);
        EXPECT_LT(oklab_hue(place), 360);
    });
    const RgbD red = oklab_from_linear({1, 0, 0});
    around(red.b, [&red](double b) {
        EXPECT_GE(dial_hue(red.g, b), 0);
        EXPECT_LT(dial_hue(red.g, b), 360);
    });
}

} // namespace
} // namespace lutlib
