#include "preview/editor/wheel.h"

#include "lutlib/color/luma.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace preview::editor {
namespace {

using lutlib::Parameter;
using lutlib::RgbD;

std::vector<const Parameter*> wheels() {
    std::vector<const Parameter*> out;
    for (const lutlib::Op* op : lutlib::ops()) {
        for (const Parameter& parameter : op->parameters) {
            if (parameter.wheel.balance > 0) {
                out.push_back(&parameter);
            }
        }
    }
    return out;
}

TEST(Wheel, is_had_by_lift_gamma_gain_offset_and_the_cdl_with_neutral_defaults) {
    EXPECT_EQ(wheels().size(), 7U);
    for (const Parameter* parameter : wheels()) {
        EXPECT_EQ(parameter->kind, lutlib::ParameterKind::rgb);
        EXPECT_GT(parameter->wheel.brightness, 0);
        const RgbD usual = parameter->fallback_rgb;
        EXPECT_TRUE(usual.r == usual.g && usual.g == usual.b) << parameter->flag;
        EXPECT_EQ(value_on_wheel(*parameter, {}), usual) << parameter->flag;
    }
}

TEST(Wheel, stands_where_the_value_was_put) {
    for (const Parameter* parameter : wheels()) {
        for (const double x : {-0.6, 0.0, 0.5}) {
            for (const double y : {-0.4, 0.3}) {
                const WheelPlace got =
                    wheel_place(*parameter, value_on_wheel(*parameter, {x, y, 0.2}));
                EXPECT_NEAR(got.x, x, 1e-12) << parameter->flag;
                EXPECT_NEAR(got.y, y, 1e-12) << parameter->flag;
                EXPECT_NEAR(got.turn, 0.2, 1e-12) << parameter->flag;
            }
        }
    }
}

TEST(Wheel, moves_colour_differences_at_the_same_luma_and_the_ring_luma_alone) {
    const Parameter& gain = lutlib::op_named("lift-gamma-gain")->parameters[2];
    const RgbD pulled = value_on_wheel(gain, {0.3, -0.2, 0});
    EXPECT_NEAR(lutlib::luma(pulled), 1, 1e-12);
    // BT.709: what Cb and Cr of a colour are.
    EXPECT_NEAR((pulled.b - lutlib::luma(pulled)) / 1.8556, 0.3 * gain.wheel.balance, 1e-12);
    EXPECT_NEAR((pulled.r - lutlib::luma(pulled)) / 1.5748, -0.2 * gain.wheel.balance, 1e-12);
    const RgbD lit = value_on_wheel(gain, {0.3, -0.2, 0.5});
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(lit[i] - pulled[i], 0.5 * gain.wheel.brightness, 1e-12);
    }
}

TEST(Wheel, lights_the_channel_that_it_is_pulled_to_whatever_the_parameter) {
    for (const lutlib::Op* op : lutlib::ops()) {
        for (std::size_t i = 0; i < op->parameters.size(); ++i) {
            if (op->parameters[i].wheel.balance == 0) {
                continue;
            }
            lutlib::Operation operation = default_operation(*op);
            operation.values[i] = value_on_wheel(op->parameters[i], {0, 0.5, 0});
            const RgbD grey{0.4, 0.4, 0.4};
            const RgbD red = op->compile(operation.values, {})(grey);
            EXPECT_GT(red.r, red.g) << op->parameters[i].flag;
            EXPECT_GT(red.r, red.b) << op->parameters[i].flag;
            operation.values[i] = value_on_wheel(op->parameters[i], {0, 0, 0.3});
            EXPECT_GT(op->compile(operation.values, {})(grey).g, 0.4) << op->parameters[i].flag;
        }
    }
}

TEST(Wheel, keeps_within_the_range_in_the_direction_that_it_was_pulled_to) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> far(-40, 40);
    for (const Parameter* parameter : wheels()) {
        for (int i = 0; i < 500; ++i) {
            const WheelPlace wanted{far(random), far(random), far(random)};
            const RgbD value = value_on_wheel(*parameter, wanted);
            EXPECT_EQ(lutlib::problem_with(*parameter, value), "") << parameter->flag;
            const WheelPlace got = wheel_place(*parameter, value);
            const double length = std::hypot(wanted.x, wanted.y);
            EXPECT_NEAR(got.x * wanted.y, got.y * wanted.x, 1e-9 * length) << parameter->flag;
        }
    }
}

TEST(Wheel, shows_red_above_and_blue_at_the_right_as_a_vectorscope_does) {
    const RgbD up = wheel_color(std::numbers::pi / 2), right = wheel_color(0);
    EXPECT_GT(up.r, up.b);
    EXPECT_GT(up.r, up.g);
    EXPECT_GT(right.b, right.r);
    EXPECT_GT(right.b, right.g);
}

} // namespace
} // namespace preview::editor
