#include "lutlib/ops/white_balance.h"

#include "lutlib/color/encoding.h"
#include "lutlib/ops/op.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lutlib {
namespace {

Transform white_balance(double kelvin, double tint, const Primaries& primaries) {
    OpContext context;
    context.primaries = primaries;
    return op_named("white-balance")->compile({kelvin, tint}, context);
}

TEST(PickedWhite, of_a_picked_colour_makes_it_neutral_where_a_light_of_the_range_has_it) {
    for (const char* gamut : {"linear/rec709", "linear/ap1", "linear/rec2020"}) {
        const Primaries primaries = require_encoding(gamut).primaries();
        for (const double kelvin : {2600.0, 4100.0, 6504.0, 9000.0, 14900.0}) {
            for (const double tint : {-20.0, -3.0, 0.0, 17.0}) {
                // Light that the operator with these values makes grey.
                const Transform apply = white_balance(kelvin, tint, primaries);
                const Matrix3 m{{{{apply({1, 0, 0}).r, apply({0, 1, 0}).r, apply({0, 0, 1}).r},
                                  {apply({1, 0, 0}).g, apply({0, 1, 0}).g, apply({0, 0, 1}).g},
                                  {apply({1, 0, 0}).b, apply({0, 1, 0}).b, apply({0, 0, 1}).b}}}};
                const RgbD cast = inverse(m) * RgbD{0.3, 0.3, 0.3};
                const auto picked = op::white_balance_of(cast, primaries);
                ASSERT_TRUE(picked);
                const RgbD grey = white_balance(picked->kelvin, picked->tint, primaries)(cast);
                EXPECT_NEAR(grey.r, grey.g, 1e-9) << gamut << ' ' << kelvin << ' ' << tint;
                EXPECT_NEAR(grey.b, grey.g, 1e-9) << gamut << ' ' << kelvin << ' ' << tint;
                EXPECT_NEAR(picked->tint, tint, 1e-6);
            }
        }
    }
}

TEST(PickedWhite, of_neutral_light_is_the_default) {
    const auto picked = op::white_balance_of({0.4, 0.4, 0.4}, rec709);
    ASSERT_TRUE(picked);
    EXPECT_NEAR(picked->kelvin, 6504, 0.01);
    EXPECT_NEAR(picked->tint, 0, 1e-4);
}

TEST(PickedWhite, of_any_colour_is_within_the_parameters_ranges_or_none) {
    const auto parameters = op_named("white-balance")->parameters;
    for (const RgbD c : {RgbD{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1e-9, 1e-9, 2e-9}}) {
        if (const auto picked = op::white_balance_of(c, rec709)) {
            EXPECT_EQ(problem_with(parameters[0], picked->kelvin), "");
            EXPECT_EQ(problem_with(parameters[1], picked->tint), "");
        } else {
            ADD_FAILURE() << c.r << ' ' << c.g << ' ' << c.b;
        }
    }
    for (const RgbD c : {RgbD{0, 0, 0}, {-1, 0, 0}, {NAN, 1, 1}, {INFINITY, 1, 1}}) {
        EXPECT_FALSE(op::white_balance_of(c, rec709));
    }
}

} // namespace
} // namespace lutlib
