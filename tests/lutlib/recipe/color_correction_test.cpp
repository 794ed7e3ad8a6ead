// Corrections as operators and back, and what of them that loses.
#include "lutlib/recipe/color_correction.h"

#include "lutlib/transform.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib {
namespace {

Recipe recipe_of(const ColorCorrection& correction) {
    std::vector<Loss> losses;
    Recipe out;
    out.operations = {operation_of(correction, losses)};
    return out;
}

bool says(const std::vector<Loss>& losses, const std::string& words) {
    return std::any_of(losses.begin(), losses.end(), [&](const Loss& loss) {
        return loss.what.find(words) != std::string::npos;
    });
}

TEST(ColorCorrection, is_an_operator_and_comes_back) {
    const ColorCorrection all{{}, {}, {1.2, 0, 10}, {-10, 0.1, 10}, {0.05, 1, 10}, 10};
    std::vector<Loss> losses;
    Recipe recipe;
    recipe.operations = {operation_of(all, losses)};
    EXPECT_TRUE(losses.empty());
    EXPECT_EQ(correction_of(recipe, 0, losses), all);
    const RgbD out =
        Transform::of(recipe_of({{}, {}, {2, 1, 1}, {0, 0.1, 0}, {1, 1, 2}, 1}))({.25, .25, .5});
    EXPECT_DOUBLE_EQ(out.r, .5);
    EXPECT_DOUBLE_EQ(out.g, .35);
    EXPECT_DOUBLE_EQ(out.b, .25);
}

TEST(ColorCorrection, beyond_the_operators_ranges_is_brought_into_them_and_told) {
    std::vector<Loss> losses;
    const ColorCorrection wild{{}, {}, {-1, 1, 1}, {12, 0, 0}, {1, 0, 1}, -0.5};
    Recipe recipe;
    recipe.operations = {operation_of(wild, losses)};
    ASSERT_EQ(losses.size(), 4U);
    EXPECT_TRUE(says(losses, "slope of red is -1; the operator takes 0 to 10, so it is 0"));
    EXPECT_TRUE(says(losses, "offset of red is 12"));
    EXPECT_TRUE(says(losses, "power of green is 0; the operator takes 0.05 to 10, so it is 0.05"));
    EXPECT_TRUE(says(losses, "saturation is -0.5"));
    EXPECT_EQ(losses[1].figure, 2);
    EXPECT_EQ(losses[2].figure, 0.05);
    losses.clear();
    const ColorCorrection held = correction_of(recipe, 0, losses);
    EXPECT_EQ(held.offset.r, 10);
    EXPECT_EQ(held.power.g, 0.05);
    EXPECT_EQ(held.saturation, 0);
}

TEST(ColorCorrection, tells_how_far_clamping_moves_colours) {
    EXPECT_EQ(clamping_of({}), 0);
    EXPECT_EQ(clamping_of({{}, {}, {0.5, 1, 1}, {0.5, 0, 0}, {2, 1, 1}, 0.5}), 0);
    EXPECT_DOUBLE_EQ(clamping_of({{}, {}, {1, 1, 1}, {-0.25, 0, 0.5}, {1, 1, 1}, 1}), 0.5);
    // Saturation alone leads outside: white's opposite, by its luma.
    EXPECT_GT(clamping_of({{}, {}, {1, 1, 1}, {}, {1, 1, 1}, 2}), 0.2);
    std::vector<Loss> losses;
    Recipe recipe = recipe_of({{}, {}, {1, 1, 1}, {}, {1, 1, 1}, 2});
    correction_of(recipe, 0, losses);
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_TRUE(says(losses, "not clamped to 0..1 here"));
    losses.clear();
    recipe.operations[0].values.back() = 1.0;
    correction_of(recipe, 0, losses);
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_TRUE(says(losses, "clamped to 0..1 here; readers that do not"));
}

TEST(ColorCorrection, of_a_look_tells_what_else_the_look_does) {
    std::vector<Loss> losses;
    Recipe recipe = recipe_of({{}, {}, {0.5, 1, 1}, {}, {1, 1, 1}, 1});
    recipe.operations.push_back(default_operation(*op_named("exposure"))); // does nothing
    correction_of(recipe, 0, losses);
    EXPECT_TRUE(losses.empty());
    recipe.operations[1].values[0] = 1.0;
    recipe.operations[0].opacity = 0.5;
    recipe.operations[0].enabled = false;
    recipe.opacity = 0.25;
    recipe.output = require_encoding("logc3");
    recipe.base_lut = std::make_shared<const Lut>();
    const ColorCorrection out = correction_of(recipe, 0, losses);
    EXPECT_EQ(out.slope.r, 0.5);
    EXPECT_EQ(losses.size(), 6U);
    for (const char* const words :
         {"other operators", "operator's opacity", "leaves out, is in the file",
          "the look's opacity", "conversion from srgb to logc3", "the LUT that"}) {
        EXPECT_TRUE(says(losses, words)) << words;
    }
}

} // namespace
} // namespace lutlib
