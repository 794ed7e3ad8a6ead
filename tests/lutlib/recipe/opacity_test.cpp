// Opacity of operators and of a whole look.
#include "lutlib/color/oklab.h"
#include "lutlib/recipe/bake_recipe.h"
#include "tests/lutlib/ops/op_samples.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

RgbD mixed(RgbD a, RgbD b, double share) {
    return a * (1 - share) + b * share;
}

void expect_near(RgbD got, RgbD want, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(got[i], want[i], tolerance * (1 + std::abs(want[i])));
    }
}

TEST(Opacity, of_an_operator_mixes_what_it_gives_with_what_it_gets_in_its_space) {
    std::mt19937 random(1);
    for (const Op* op : ops()) {
        SCOPED_TRACE(std::string(op->name));
        if (op->space == Space::oklab) {
            continue; // by the next test
        }
        const Operation whole = test::some_operation(*op, random);
        Operation part = whole;
        part.opacity = 0.3;
        const Transform change = op->compile(whole.values, {});
        // Nothing is converted between the recipe's codes and the operator's space.
        Recipe recipe;
        recipe.input = require_encoding(op->space == Space::linear ? "linear" : "srgb");
        recipe.operations = {part};
        for (const RgbD c : {RgbD{0.2, 0.4, 0.7}, {0.9, 0.5, 0.1}, {0.33, 0.33, 0.33}}) {
            expect_near(Transform::of(recipe)(c), mixed(c, change(c), 0.3), 1e-12);
        }
    }
}

TEST(Opacity, of_an_operator_on_oklab_mixes_there) {
    Recipe recipe;
    recipe.input = require_encoding("linear");
    recipe.operations = {default_operation(*op_named("hue-vs-sat"))};
    recipe.operations[0].values[0] = Knots{{0, 0}}; // grey
    recipe.operations[0].opacity = 0.25;
    const RgbD c{0.6, 0.2, 0.1}, lab = oklab_from_linear(c);
    expect_near(Transform::of(recipe)(c), linear_from_oklab({lab.r, 0.75 * lab.g, 0.75 * lab.b}),
                1e-6);
}

TEST(Opacity, of_the_whole_look_mixes_codes_of_the_result_with_the_conversion_alone) {
    Recipe recipe;
    recipe.input = require_encoding("logc3/rec709");
    recipe.output = require_encoding("srgb");
    recipe.operations = {default_operation(*op_named("exposure"))};
    recipe.operations[0].values[0] = 1.0;
    const Transform whole = Transform::of(recipe), plain = Transform::of(without_look(recipe));
    recipe.opacity = 0.6;
    const RgbD c{0.3, 0.4, 0.5};
    expect_near(Transform::of(recipe)(c), mixed(plain(c), whole(c), 0.6), 1e-12);
    recipe.opacity = 0;
    expect_near(Transform::of(recipe)(c), plain(c), 1e-12);
}

TEST(Opacity, of_a_look_with_a_base_mixes_with_what_goes_into_the_base) {
    Lut base;
    base.shaper = Lut1D{{}, {{0.5F, 0.5F, 0.5F}, {1, 1, 1}}};
    Recipe recipe;
    recipe.base = "base.cube";
    recipe.base_lut = std::make_shared<const Lut>(base);
    recipe.opacity = 0.5;
    expect_near(Transform::of(recipe)({0, 0.5, 1}), {0.25, 0.625, 1}, 1e-12);
}

TEST(Opacity, holds_for_batches_of_any_size_as_for_one_colour) {
    Recipe recipe;
    recipe.operations = {default_operation(*op_named("lift-gamma-gain"))};
    recipe.operations[0].values[1] = RgbD{1.2, 0.9, 2};
    recipe.operations[0].opacity = 0.5;
    recipe.opacity = 0.7;
    const Transform look = Transform::of(recipe);
    const std::vector<RgbD> before = test::many_colors(1000);
    for (const std::size_t count : {1U, 255U, 256U, 257U, 1000U}) {
        std::vector<RgbD> colors(before.begin(),
                                 before.begin() + static_cast<std::ptrdiff_t>(count));
        look(colors);
        for (std::size_t i = 0; i < count; ++i) {
            // Powers of many at once round in the last places.
            for (std::size_t c = 0; c < 3; ++c) {
                const double want = look(before[i])[c];
                ASSERT_NEAR(colors[i][c], want, 1e-12 * (1 + std::abs(want)));
            }
        }
    }
}

TEST(Opacity, of_nothing_leaves_a_recipe_the_identity_to_the_bit) {
    Recipe recipe;
    recipe.operations = {default_operation(*op_named("exposure"))};
    recipe.operations[0].values[0] = 3.0;
    recipe.operations[0].opacity = 0;
    EXPECT_TRUE(is_identity(recipe.operations[0]));
    EXPECT_EQ(Transform::of(recipe)({0.1, 0.2, 0.3}), (RgbD{0.1, 0.2, 0.3}));
}

TEST(Opacity, keeps_a_recipe_of_curves_a_curve) {
    Recipe recipe;
    recipe.operations = {default_operation(*op_named("exposure"))};
    recipe.operations[0].values[0] = 1.0;
    recipe.operations[0].opacity = 0.5;
    recipe.opacity = 0.5;
    EXPECT_FALSE(mixes_channels(recipe));
    const Lut lut = bake_recipe(recipe);
    EXPECT_TRUE(lut.shaper && !lut.cube);
}

} // namespace
} // namespace lutlib
