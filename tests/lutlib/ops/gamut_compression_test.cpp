// Gamut compression: nothing stays outside, hue and lightness stay, and it does so softly.
#include "lutlib/color/encoding.h"
#include "lutlib/color/oklab.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace lutlib {
namespace {

struct Settings {
    double amount = 1, threshold = 0.8, limit = 1.4, peak = 1;
};

Transform compressed(const Settings& s, const char* input = "linear", const char* output = "") {
    Recipe recipe;
    recipe.input = require_encoding(input);
    if (*output) {
        recipe.output = require_encoding(output);
    }
    recipe.operations = {
        {op_named("gamut-compression"), {s.amount, s.threshold, s.limit, s.peak}, true}};
    return Transform::of(recipe);
}

RgbD light_at(double L, double C, double degrees) {
    const double t = degrees * std::numbers::pi / 180;
    return linear_from_oklab({L, C * std::cos(t), C * std::sin(t)});
}

bool holds(RgbD c, double peak) {
    return std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= peak + 1e-12;
}

TEST(GamutCompression, leaves_nothing_outside_the_gamut_of_the_result) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> code(-1, 3);
    for (const auto& [input, output] :
         {std::pair("linear", ""), {"srgb", ""}, {"linear/rec2020", ""}, {"logc3", "srgb"}}) {
        for (const double peak : {1.0, 4.0}) {
            const Transform edit = compressed({.peak = peak}, input, output);
            const Encoding result = require_encoding(*output ? output : input);
            for (int i = 0; i < 20000; ++i) {
                const RgbD c = edit({code(random), code(random), code(random)});
                const RgbD light{result.decode(c.r), result.decode(c.g), result.decode(c.b)};
                ASSERT_TRUE(holds(light, peak * (1 + 1e-9)))
                    << input << ' ' << light.r << ' ' << light.g << ' ' << light.b;
            }
        }
    }
}

TEST(GamutCompression, keeps_hue_and_lightness) {
    const Transform edit = compressed({});
    for (double degrees = 0; degrees < 360; degrees += 5) {
        for (const double L : {0.1, 0.4, 0.7, 0.95}) {
            for (const double C : {0.01, 0.1, 0.25, 0.6}) {
                const RgbD lab = oklab_from_linear(edit(light_at(L, C, degrees)));
                EXPECT_NEAR(lab.r, L, 1e-9);
                const double hue = std::atan2(lab.b, lab.g) * 180 / std::numbers::pi;
                // What is left of chroma near white is too little for a hue.
                if (std::hypot(lab.g, lab.b) > 1e-6) {
                    EXPECT_NEAR(std::remainder(hue - degrees, 360), 0, 1e-6);
                }
            }
        }
    }
}

TEST(GamutCompression, changes_nothing_below_its_threshold_and_no_neutral_inside) {
    const Transform edit = compressed({});
    for (double degrees = 0; degrees < 360; degrees += 3) {
        for (const double L : {0.2, 0.5, 0.8}) {
            // The edge by bisection, of the definition itself.
            double low = 0, high = 1;
            for (int i = 0; i < 50; ++i) {
                const double middle = (low + high) / 2;
                (holds(light_at(L, middle, degrees), 1) ? low : high) = middle;
            }
            const RgbD kept = light_at(L, 0.799 * low, degrees), moved = light_at(L, low, degrees);
            EXPECT_LT(largest_magnitude(edit(kept) - kept), 1e-12);
            const double chroma =
                std::hypot(oklab_from_linear(edit(moved)).g, oklab_from_linear(edit(moved)).b);
            // At distance 1: 0.8 + 0.2 (1 - (2/3)^3).
            EXPECT_NEAR(chroma / low, 0.8 + 0.2 * (1 - 8.0 / 27), 1e-6);
        }
    }
    for (double v = 0; v <= 1; v += 1.0 / 64) {
        EXPECT_LT(largest_magnitude(edit({v, v, v}) - RgbD{v, v, v}), 1e-12);
    }
    EXPECT_LT(largest_magnitude(edit({1.5, 1.5, 1.5}) - RgbD{1, 1, 1}), 1e-12);
    EXPECT_LT(largest_magnitude(edit({-.5, -.5, -.5})), 1e-12);
}

TEST(GamutCompression, rises_with_chroma_without_a_kink) {
    for (const Settings& settings :
         {Settings{}, Settings{.amount = 0.5}, Settings{.threshold = 0.3, .limit = 2}}) {
        // In Oklab itself: on the way there and back cube roots magnify rounding.
        const Transform edit =
            op_named("gamut-compression")
                ->compile({settings.amount, settings.threshold, settings.limit, settings.peak}, {});
        const double L = 0.6, step = 1e-4;
        for (double degrees = 0; degrees < 360; degrees += 15) {
            double before = 0, slope_before = 1;
            for (double C = step; C < 1; C += step) {
                const double t = degrees * std::numbers::pi / 180;
                const RgbD lab = edit({L, C * std::cos(t), C * std::sin(t)});
                const double now = std::hypot(lab.g, lab.b), slope = (now - before) / step;
                ASSERT_GE(slope, -1e-6) << C;
                // The second derivative is bounded, by k (k - 1) / (limit - threshold) of the edge.
                ASSERT_LT(std::abs(slope - slope_before), 0.03) << degrees << ' ' << C;
                before = now;
                slope_before = slope;
            }
        }
    }
}

} // namespace
} // namespace lutlib
