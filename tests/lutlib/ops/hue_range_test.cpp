// The qualifiers of the hue range, held to a plain twin.
#include "lutlib/color/oklab.h"
#include "lutlib/ops/op.h"
#include "lutlib/recipe/recipe.h"
#include "tests/lutlib/ops/op_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lutlib {
namespace {

Operation range(const std::vector<std::pair<std::string_view, double>>& values) {
    Operation out = default_operation(*op_named("hue-range"));
    for (const auto& [name, value] : values) {
        for (std::size_t i = 0; i < out.values.size(); ++i) {
            if (out.op->parameters[i].name == name) {
                out.values[i] = value;
            }
        }
    }
    return out;
}

RgbD on_oklab(const Operation& operation, RgbD lab) {
    return operation.op->compile(operation.values, {})(lab);
}

RgbD lab_of(double lightness, double chroma, double dial) {
    const double angle = oklab_hue(dial) * std::numbers::pi / 180;
    return {lightness, chroma * std::cos(angle), chroma * std::sin(angle)};
}

TEST(HueRange, chooses_by_hue_saturation_and_luminance_as_their_product) {
    const auto cosine = [](double outside, double softness) {
        return outside <= 0          ? 1.0
               : outside >= softness ? 0.0
                                     : (1 + std::cos(outside / softness * std::numbers::pi)) / 2;
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const double centre = 360 * unit(random), hue = 360 * unit(random);
        const double low = 0.1 + 0.3 * unit(random), high = 0.5 + 0.3 * unit(random);
        const double dark = 0.1 + 0.3 * unit(random), bright = 0.5 + 0.4 * unit(random);
        const double s = unit(random), l = unit(random);
        const Operation matte = range({{"centre", centre},
                                       {"width", 50},
                                       {"softness", 40},
                                       {"saturation_low", low},
                                       {"saturation_high", high},
                                       {"saturation_softness", 0.2},
                                       {"luminance_low", dark},
                                       {"luminance_high", bright},
                                       {"luminance_softness", 0.15},
                                       {"matte", 1}});
        const double turned = std::min(std::abs(hue - centre), 360 - std::abs(hue - centre));
        const double chroma = s * srgb_chroma;
        const double counts = chroma * chroma / (chroma * chroma + std::pow(srgb_chroma / 10, 2));
        const double want = cosine(turned - 25, 40) * cosine(std::max(low - s, s - high), 0.2) *
                            cosine(std::max(dark - l, l - bright), 0.15) * counts;
        const RgbD got = on_oklab(matte, lab_of(l, chroma, hue));
        EXPECT_NEAR(got.r, want, 1e-9);
        EXPECT_EQ(got.g, 0);
        EXPECT_EQ(got.b, 0);
    }
}

TEST(HueRange, takes_neutrals_by_luminance_alone_where_any_hue_is_chosen) {
    const Operation dark = range(
        {{"any_hue", 1}, {"luminance", 1.5}, {"luminance_high", 0.3}, {"luminance_softness", 0.1}});
    EXPECT_DOUBLE_EQ(on_oklab(dark, {0.2, 0, 0}).r, 0.3);
    EXPECT_DOUBLE_EQ(on_oklab(dark, {0.35, 0, 0}).r, 0.35 * 1.25);
    EXPECT_DOUBLE_EQ(on_oklab(dark, {0.5, 0, 0}).r, 0.5);
}

TEST(HueRange, has_no_outside_at_the_ends_of_its_qualifiers) {
    const Operation turns = range({{"centre", 0}, {"width", 360}, {"luminance", 1.5}});
    for (const double lightness : {-0.2, 0.0, 0.5, 1.0, 3.0}) {
        const RgbD c = lab_of(lightness, 2 * srgb_chroma, 200);
        EXPECT_NEAR(on_oklab(turns, c).r, lightness * (1 + 0.5 * 400 / 401), 1e-9) << lightness;
    }
}

TEST(HueRange, has_no_seam_whatever_its_qualifiers) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 200; ++round) {
        Operation any = test::some_operation(*op_named("hue-range"), random);
        any.values.back() = 0.0; // the matte
        any.values[6] = unit(random) < 0.5 ? 0.0 : 1.0;
        ASSERT_EQ(any.op->parameters[6].name, "any_hue");
        ASSERT_EQ(any.op->parameters.back().name, "matte");
        const Transform edit = any.op->compile(any.values, {});
        for (int i = 0; i < 200; ++i) {
            const RgbD lab = lab_of(1.2 * unit(random), 0.4 * unit(random), 360 * unit(random));
            const RgbD step{1e-7 * unit(random), 1e-7 * unit(random), 1e-7};
            // Softness of 0.01 of a chroma of .3225, a gain of 4.
            EXPECT_LT(largest_magnitude(edit(lab + step) - edit(lab)),
                      1e4 * largest_magnitude(step));
        }
    }
}

TEST(HueRange, ends_a_recipe_with_its_matte_and_says_so) {
    Recipe recipe;
    recipe.operations = {range({{"centre", 0}, {"matte", 1}}),
                         default_operation(*op_named("exposure"))};
    const RgbD red{0.8, 0.1, 0.1}, green{0.1, 0.8, 0.1};
    const RgbD alone = Transform::of(recipe)(red);
    recipe.operations[1].values[0] = 2.0;
    EXPECT_EQ(Transform::of(recipe)(red), alone);
    EXPECT_GT(alone.r, 0.8);
    EXPECT_NEAR(alone.r, alone.g, 1e-6); // by the published constants of Oklab
    EXPECT_LT(Transform::of(recipe)(green).r, 1e-6);
    ASSERT_EQ(notes_of(recipe).size(), 1U);
    EXPECT_NE(notes_of(recipe)[0].find("--range-matte"), std::string::npos);
}

} // namespace
} // namespace lutlib
