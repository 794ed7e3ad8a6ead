// The table of effects, their uses as text, and what the finishing pass does itself.
#include "lutlib/error.h"
#include "preview/effects/fusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace preview {
namespace {

const PostEffect& named(std::string_view name) {
    return *post_effect_named(name);
}

class EveryEffect : public testing::TestWithParam<const PostEffect*> {};

TEST_P(EveryEffect, starts_with_a_strength_that_leaves_it_out_at_0_and_is_in_use_otherwise) {
    const PostEffect& effect = *GetParam();
    ASSERT_FALSE(effect.parameters.empty());
    EXPECT_EQ(effect.parameters[0].name, "strength");
    EXPECT_EQ(effect.parameters[0].min, 0);
    EffectUse use = usual_use(effect);
    EXPECT_GT(strength_of(use), 0);
    EXPECT_EQ(left_out_because(use, {}), "");
    use.values[0] = 0.0;
    EXPECT_EQ(left_out_because(use, {}), "its strength is 0");
}

TEST_P(EveryEffect, has_numbers_and_toggles_with_usual_values_within_their_ranges) {
    for (const lutlib::Parameter& parameter : GetParam()->parameters) {
        EXPECT_TRUE(parameter.kind == lutlib::ParameterKind::number ||
                    parameter.kind == lutlib::ParameterKind::toggle)
            << parameter.name;
        EXPECT_EQ(lutlib::problem_with(parameter, lutlib::default_value(parameter)), "")
            << parameter.name;
        EXPECT_FALSE(parameter.label.empty()) << parameter.name;
    }
}

TEST_P(EveryEffect, is_told_apart_and_explained) {
    const PostEffect& effect = *GetParam();
    EXPECT_EQ(post_effect_named(effect.name), &effect);
    EXPECT_FALSE(effect.help.empty());
    EXPECT_FALSE(effect.reference.empty());
    EXPECT_NE(effect.add, nullptr);
}

TEST_P(EveryEffect, reads_back_from_its_text) {
    EffectUse use = usual_use(*GetParam());
    for (std::size_t i = 0; i < use.values.size(); ++i) {
        use.values[i] = GetParam()->parameters[i].max;
    }
    EXPECT_EQ(parse_use(use_text(use)), use);
    EXPECT_EQ(parse_use(std::string(GetParam()->name)), usual_use(*GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Table, EveryEffect,
                         testing::ValuesIn(post_effects().begin(), post_effects().end()),
                         [](const auto& row) {
                             std::string name(row.param->name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(EffectText, refuses_what_is_no_effect_parameter_or_value_and_says_what_there_is) {
    const auto complaint = [](const char* text) -> std::string {
        try {
            parse_use(text);
        } catch (const lutlib::UsageError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_EQ(complaint("nothing").find("there is no effect 'nothing'; there are "), 0U);
    for (const PostEffect* effect : post_effects()) {
        EXPECT_NE(complaint("nothing").find(effect->name), std::string::npos);
    }
    EXPECT_EQ(complaint("vignette:size=1"),
              "--effect vignette: 'size=1' sets no parameter; write NAME=VALUE with one of: "
              "strength, angle");
    EXPECT_EQ(complaint("vignette:"),
              "--effect vignette: '' sets no parameter; write NAME=VALUE with one of: strength, "
              "angle");
    EXPECT_NE(complaint("vignette:strength=2").find("--effect vignette:strength is 2"),
              std::string::npos)
        << complaint("vignette:strength=2");
    EXPECT_NE(complaint("vignette:strength=much").find("takes a number"), std::string::npos);
    EXPECT_NE(complaint("vignette:before-look=1").find("sets no parameter"), std::string::npos);
    EXPECT_EQ(complaint("sharpen:size=1"),
              "--effect sharpen: 'size=1' sets no parameter; write NAME=VALUE with one of: "
              "strength, reach, before-look");
}

TEST(EffectText, puts_effects_on_codes_before_the_looks) {
    const EffectUse usual = parse_use("sharpen"), moved = parse_use("sharpen:before-look=1");
    EXPECT_EQ(stage_of(usual), Stage::after_look);
    EXPECT_EQ(stage_of(moved), Stage::before_look);
    EXPECT_EQ(parse_use(use_text(moved)), moved);
    EXPECT_EQ(parse_use("sharpen:before-look=0"), usual);
}

TEST(EffectUses, have_each_effect_once_and_the_usual_ones_first) {
    EffectUses uses;
    put_use(uses, parse_use("vignette"));
    set_usual(uses, true);
    put_use(uses, parse_use("vignette:strength=0.5"));
    ASSERT_EQ(uses.size(), 2U);
    EXPECT_EQ(uses[0].effect, &named("fxaa"));
    EXPECT_EQ(strength_of(uses[1]), 0.5);
    put_use(uses, parse_use("fxaa:strength=0.25"));
    set_usual(uses, true); // keeps what it finds
    EXPECT_EQ(strength_of(uses[0]), 0.25);
    set_usual(uses, false);
    EXPECT_EQ(use_of(uses, named("fxaa")), nullptr);
    take_out(uses, named("vignette"));
    EXPECT_TRUE(uses.empty());
}

TEST(Fusion, keeps_the_finishing_pass_whole_wherever_no_effect_sits_between) {
    PostEffect before_tonemap = named("vignette");
    before_tonemap.stage = Stage::before_tonemap;
    const EffectUses none, on_light{parse_use("vignette")}, finished{parse_use("fxaa")},
        between{usual_use(before_tonemap)};
    for (const Compare& compare : compares) {
        const bool is_divided = compare.shows_one;
        EXPECT_EQ(fusion_of(none, compare), Fusion{}) << compare.name;
        EXPECT_EQ(fusion_of(on_light, compare), Fusion{}) << compare.name;
        EXPECT_EQ(fusion_of(finished, compare), (Fusion{false, is_divided})) << compare.name;
        EXPECT_EQ(fusion_of(between, compare), (Fusion{true, false})) << compare.name;
    }
}

TEST(LeftOut, are_effects_on_light_from_display_encoded_pictures_and_on_pictures_from_heat_maps) {
    for (const PostEffect* effect : post_effects()) {
        const EffectUse use = usual_use(*effect);
        const bool is_on_light = !is_on_codes(effect->stage);
        EXPECT_EQ(left_out_because(use, {.is_display_encoded = true}).empty(), !is_on_light)
            << effect->name;
        EXPECT_EQ(left_out_because(use, {.compare = &compare_difference}).empty(), is_on_light)
            << effect->name;
    }
    // Looks take what those before them make, and their difference can be shown.
    const EffectUse moved = parse_use("sharpen:before-look=1");
    EXPECT_EQ(left_out_because(moved, {.compare = &compare_difference}), "");
    EXPECT_EQ(left_out_because(moved, {.is_display_encoded = true}), "");
    EXPECT_EQ(left_out_because(moved, {.has_scene_look = true}),
              "a look takes light: no codes reach it");
    EXPECT_EQ(left_out_because(parse_use("sharpen"), {.has_scene_look = true}), "");
}

TEST(LeftOut, are_effects_that_need_depth_where_there_is_none) {
    for (const PostEffect* effect : post_effects()) {
        EXPECT_EQ(left_out_because(usual_use(*effect), {.has_depth = false}),
                  effect->needs_depth ? "it needs the depth of a scene, and a picture has none"
                                      : "")
            << effect->name;
    }
}

} // namespace
} // namespace preview
