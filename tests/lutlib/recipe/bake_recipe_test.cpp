#include "lutlib/recipe/bake_recipe.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/transform.h"
#include "tests/lutlib/ops/op_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lutlib {
namespace {

Operation operation(const char* name, const Values& values) {
    return {op_named(name), values, true};
}

Recipe warm(const char* input = "srgb") {
    Recipe recipe;
    recipe.input = require_encoding(input);
    recipe.operations = {
        operation("exposure", {0.3}),
        operation("saturation", {1.3}),
        operation("hue-vs-sat", {Knots{{0, 1.1}, {120, 0.7}, {240, 1.3}}}),
    };
    return recipe;
}

Lut random_base(int size, const Domain& domain) {
    Lut lut;
    lut.cube = identity_cube(size, domain);
    for (std::size_t i = 0; i < lut.cube->nodes.size(); ++i) {
        Rgb& c = lut.cube->nodes[i];
        c = {c.g * 0.25F, c.r * 0.2F + 0.01F * static_cast<float>(i % 7), c.b * 0.25F};
    }
    return lut;
}

TEST(BakeRecipe, holds_the_exact_recipe_at_every_node) {
    Recipe recipe = warm();
    recipe.bake = {9, Domain{{-.5F, 0, 0}, {4, 1, 2}}, "", 0};
    const Lut lut = bake_recipe(recipe);
    ASSERT_FALSE(lut.shaper);
    const Transform edit = Transform::of(recipe);
    for (int b = 0; b < 9; ++b) {
        for (int g = 0; g < 9; ++g) {
            for (int r = 0; r < 9; ++r) {
                EXPECT_EQ(lut.cube->at(r, g, b), to_float(edit(node_position(*lut.cube, r, g, b))));
            }
        }
    }
}

TEST(BakeRecipe, of_no_operators_is_the_identity_bit_for_bit) {
    for (const Encoding& encoding : encodings()) {
        Recipe recipe;
        recipe.input = encoding;
        recipe.operations = {default_operation(*op_named("exposure")),
                             operation("hue-vs-hue", {Knots{{0, 0}, {200, 0}}})};
        EXPECT_EQ(bake_recipe(recipe).cube->nodes, identity_cube(33).nodes);
    }
}

TEST(BakeRecipe, skips_operations_that_are_switched_off) {
    Recipe recipe = warm();
    for (Operation& op : recipe.operations) {
        op.enabled = false;
    }
    EXPECT_EQ(Transform::of(recipe)({.2, .4, .6}), (RgbD{.2, .4, .6}));
}

TEST(BakeRecipe, applies_operators_in_order_and_the_base_first) {
    Recipe recipe;
    recipe.base_lut = std::make_shared<const Lut>(random_base(5, {}));
    recipe.operations = {operation("offset", {RgbD{.1, .1, .1}}),
                         operation("contrast", {2.0, 0.0})};
    const RgbD in{.3, .5, .7};
    const RgbD expected = (evaluate_exact(*recipe.base_lut, in) + RgbD{.1, .1, .1}) * 2.0;
    const RgbD got = Transform::of(recipe)(in);
    EXPECT_NEAR(got.r, expected.r, 1e-15);
    EXPECT_NEAR(got.g, expected.g, 1e-15);
    EXPECT_NEAR(got.b, expected.b, 1e-15);
    EXPECT_EQ(bake_recipe(recipe).cube->size, 5);
}

TEST(BakeRecipe, of_a_base_alone_gives_the_base_back_with_its_shaper) {
    Lut base = random_base(6, Domain{{0, 0, 0}, {2, 2, 2}});
    base.shaper = Lut1D{{{-1, 0, 0}, {7, 8, 9}}, {{0, 0, 0}, {.5F, 1.5F, .1F}, {2, 1, 2}}};
    Recipe recipe;
    recipe.base_lut = std::make_shared<const Lut>(base);
    const Lut lut = bake_recipe(recipe);
    EXPECT_EQ(lut.shaper, base.shaper);
    EXPECT_EQ(lut.cube, base.cube);
}

TEST(BakeRecipe, follows_a_1d_base_without_resampling_its_table) {
    Lut base;
    base.shaper = Lut1D{{}, {{.1F, 0, .2F}, {.4F, .9F, .3F}, {.8F, 1, 1}}};
    Recipe recipe;
    recipe.base_lut = std::make_shared<const Lut>(base);
    const Lut lut = bake_recipe(recipe);
    for (double x = 0; x <= 1; x += 0.01) {
        const RgbD want = evaluate_exact(base, {x, x, x}), got = evaluate_exact(lut, {x, x, x});
        EXPECT_NEAR(got.r, want.r, 1e-6);
        EXPECT_NEAR(got.g, want.g, 1e-6);
        EXPECT_NEAR(got.b, want.b, 1e-6);
    }
}

// Where a shaper that is the same in every channel reaches each of `size` nodes, by bisection.
std::vector<double> inputs_of_nodes(const Lut1D& shaper, int size) {
    std::vector<double> out;
    for (int i = 0; i < size; ++i) {
        double low = shaper.domain.min.r, high = shaper.domain.max.r;
        for (int step = 0; step < 80; ++step) {
            const double middle = (low + high) / 2;
            const double y = evaluate_exact(shaper, {middle, middle, middle}).r;
            (y < static_cast<double>(i) / (size - 1) ? low : high) = middle;
        }
        out.push_back(high);
    }
    return out;
}

TEST(BakeRecipe, with_a_shaper_holds_the_exact_recipe_at_every_node) {
    struct Case {
        const char *input, *shaper;
        Domain domain;
    };
    for (const Case& row : {Case{"linear", "logc3", {{0, 0, 0}, {50, 50, 50}}},
                            Case{"linear", "srgb", {{0, 0, 0}, {4, 4, 4}}},
                            Case{"srgb", "tone", {}}, Case{"logc3", "tone", {}}}) {
        Recipe recipe = warm(row.input);
        recipe.output = srgb();
        recipe.bake = {17, row.domain, row.shaper, 1024};
        const Lut lut = bake_recipe(recipe);
        ASSERT_TRUE(lut.shaper);
        EXPECT_TRUE(lut.cube->domain.is_unit());
        const Transform edit = Transform::of(recipe);
        const std::vector<double> axis = inputs_of_nodes(*lut.shaper, 17);
        for (std::size_t k = 0; k < lut.cube->nodes.size(); ++k) {
            const RgbD want = edit({axis[k % 17], axis[k / 17 % 17], axis[k / (17 * 17)]});
            const RgbD d = to_double(lut.cube->nodes[k]) - want;
            ASSERT_LT(largest_magnitude(d), 1e-6 * (1 + largest_magnitude(want)))
                << row.shaper << " at node " << k;
        }
    }
}

TEST(BakeRecipe, is_nearer_to_a_log_look_with_a_shaper_than_without) {
    Recipe recipe = warm("linear");
    recipe.output = srgb();
    const auto worst = [&](const char* shaper) {
        recipe.bake = {33, Domain{{0, 0, 0}, {16, 16, 16}}, shaper, 4096};
        const Lut lut = bake_recipe(recipe);
        const Transform edit = Transform::of(recipe);
        double error = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double x = 16 * std::pow(i / 1000.0, 4);
            error = std::max(error, std::abs(evaluate_exact(lut, {x, x, x}).g - edit({x, x, x}).g));
        }
        return error;
    };
    EXPECT_LT(worst("logc3"), 0.05 * worst("none"));
}

TEST(BakeRecipe, refuses_a_shaper_that_cannot_be) {
    Recipe recipe = warm("linear");
    recipe.bake.shaper = "base";
    EXPECT_THROW(bake_recipe(recipe), Error);
    recipe.bake = {9, Domain{{-1, -1, -1}, {1, 1, 1}}, "pq", 64};
    EXPECT_THROW(bake_recipe(recipe), Error);
    recipe.base = "missing.cube";
    EXPECT_THROW(Transform::of(recipe), Error);
}

TEST(BakeRecipe, of_channels_that_do_not_mix_is_a_curve) {
    Recipe recipe;
    EXPECT_TRUE(bake_recipe(recipe).cube) << "nothing is a lattice";
    recipe.operations = {operation("exposure", {1.0}), operation("contrast", {1.5, 0.4})};
    EXPECT_FALSE(mixes_channels(recipe));
    const Lut curve = bake_recipe(recipe);
    ASSERT_TRUE(curve.shaper && !curve.cube);
    const Transform exact = Transform::of(recipe);
    for (const Rgb& in : samples_over({}, 9, 1000)) {
        const RgbD d = evaluate_exact(curve, to_double(in)) - exact(to_double(in));
        EXPECT_LT(largest_magnitude(d), 3e-5);
    }
    recipe.bake.size = 9;
    EXPECT_EQ(bake_recipe(recipe).cube->size, 9) << "a size is of cubes";
    recipe.bake.size.reset();
    recipe.operations.push_back(operation("saturation", {0.5}));
    EXPECT_TRUE(mixes_channels(recipe));
    EXPECT_TRUE(bake_recipe(recipe).cube);
    recipe.operations.back().enabled = false;
    EXPECT_FALSE(mixes_channels(recipe));
}

// Whatever an operator says of its channels holds: one channel of the input moves one of the
// output.
TEST(MixesChannels, is_told_by_every_operator_that_does) {
    std::mt19937 random(1);
    for (const Op* op : ops()) {
        for (const Operation& tried :
             {test::some_operation(*op, random), test::extreme_operation(*op, true),
              test::extreme_operation(*op, false)}) {
            Recipe recipe;
            recipe.operations = {tried};
            if (is_identity(tried) || mixes_channels(recipe)) {
                continue;
            }
            const Transform look = Transform::of(recipe);
            for (const Rgb& in : samples_over({{-.5F, -.5F, -.5F}, {2, 2, 2}}, 4, 300)) {
                const RgbD all = look(to_double(in)), red = look({in.r, .3, .1}),
                           blue = look({.7, .2, in.b});
                EXPECT_EQ(all.r, red.r) << op->name;
                EXPECT_EQ(all.b, blue.b) << op->name;
            }
        }
    }
}

} // namespace
} // namespace lutlib
