#include "lutlib/transform.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/resample/resample.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <random>

namespace lutlib {
namespace {

std::vector<Rgb> some_colors(int count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> value(-0.2F, 1.2F);
    std::vector<Rgb> out;
    for (int i = 0; i < count; ++i) {
        out.push_back({value(random), value(random), value(random)});
    }
    return out;
}

Lut strong_lut() {
    Lut lut;
    lut.shaper = Lut1D{{{-0.1F, -0.1F, -0.1F}, {1.1F, 1.1F, 1.1F}}, {{0, 0, 0}, {1, .7F, .9F}}};
    lut.cube = sampled(test_looks()[1].f, 9);
    return lut;
}

Recipe strong_recipe() {
    Recipe recipe;
    recipe.base_lut = std::make_shared<const Lut>(strong_lut());
    recipe.base = "base.cube";
    recipe.operations = {{op_named("exposure"), {0.3}, true},
                         {op_named("saturation-perceptual"), {1.3}, true},
                         {op_named("contrast"), {1.15, .435}, true}};
    return recipe;
}

TEST(Transform, changes_nothing_unless_it_was_made_of_something) {
    EXPECT_EQ(Transform()(RgbD{.1, -2, 7}), (RgbD{.1, -2, 7}));
    EXPECT_EQ(Transform().precision(), Precision::float64);
}

TEST(Transform, answers_one_color_as_it_answers_many) {
    const Lut lut = strong_lut();
    std::vector<Transform> all{Transform::of(strong_recipe()), test_looks()[2].transform()};
    for (const InterpolationInfo& row : interpolations()) {
        all.push_back(Transform::of(lut, row.kind));
    }
    for (const ResamplingMethod& method : resampling_methods()) {
        all.push_back(method.transform_of(lut));
    }
    const std::vector<Rgb> inputs = some_colors(5000);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::vector<RgbD> many = images_of(all[k], inputs);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            ASSERT_EQ(all[k](to_double(inputs[i])), many[i]) << k << ' ' << i;
        }
    }
}

TEST(Transform, of_a_lut_is_the_double_oracle) {
    const auto lut = std::make_shared<const Lut>(strong_lut());
    for (const InterpolationInfo& row : interpolations()) {
        for (const Rgb& in : some_colors(1000)) {
            ASSERT_EQ(Transform::of(lut, row.kind)(to_double(in)),
                      evaluate_exact(*lut, to_double(in), row.kind));
        }
    }
}

TEST(Transform, keeps_the_lut_that_it_shares) {
    Transform transform;
    {
        transform =
            Transform::of(std::make_shared<const Lut>(strong_lut()), Interpolation::tetrahedral);
    }
    EXPECT_EQ(transform(RgbD{.2, .4, .6}), evaluate_exact(strong_lut(), {.2, .4, .6}));
}

TEST(Transform, never_gives_a_function_an_empty_batch) {
    const Transform refuses = Transform::batch([](std::span<RgbD>) { FAIL(); });
    refuses(std::span<RgbD>());
    apply_in_parallel(refuses, {});
}

TEST(Transform, in_sequence_applies_the_first_first_and_is_as_coarse_as_the_coarsest) {
    const Transform half = Transform::each([](RgbD c) { return c * 0.5; });
    const Transform plus = Transform::each([](RgbD c) { return c + RgbD{1, 1, 1}; });
    const Transform coarse = Transform::batch([](std::span<RgbD>) {}, Precision::float32);
    EXPECT_EQ(in_sequence({half, plus})(RgbD{1, 2, 3}), (RgbD{1.5, 2, 2.5}));
    EXPECT_EQ(in_sequence({plus, half})(RgbD{1, 2, 3}), (RgbD{1, 1.5, 2}));
    EXPECT_EQ(in_sequence({half, plus}).precision(), Precision::float64);
    EXPECT_EQ(in_sequence({half, coarse, plus}).precision(), Precision::float32);
    EXPECT_EQ(in_sequence({})(RgbD{1, 2, 3}), (RgbD{1, 2, 3}));
}

} // namespace
} // namespace lutlib
