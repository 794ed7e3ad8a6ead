// What single operators do, in values that can be worked out by hand.
#include "lutlib/color/encoding.h"
#include "lutlib/color/oklab.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lutlib {
namespace {

struct Set {
    const char* parameter;
    Value value;
};

Transform edit_with(const char* name, const std::vector<Set>& settings,
                    const char* input = "srgb") {
    Recipe recipe;
    recipe.input = require_encoding(input);
    Operation operation = default_operation(*op_named(name));
    for (const Set& setting : settings) {
        for (std::size_t i = 0; i < operation.values.size(); ++i) {
            if (operation.op->parameters[i].name == setting.parameter) {
                operation.values[i] = setting.value;
            }
        }
    }
    recipe.operations = {operation};
    return Transform::of(recipe);
}

void expect_near(RgbD got, RgbD want, double tolerance) {
    EXPECT_NEAR(got.r, want.r, tolerance);
    EXPECT_NEAR(got.g, want.g, tolerance);
    EXPECT_NEAR(got.b, want.b, tolerance);
}

RgbD in_oklab(const Transform& edit, RgbD lab) {
    return oklab_from_linear(edit(linear_from_oklab(lab)));
}

double chroma(RgbD lab) {
    return std::hypot(lab.g, lab.b);
}

RgbD lab_at(double L, double C, double dial) {
    const double t = oklab_hue(dial) * std::numbers::pi / 180;
    return {L, C * std::cos(t), C * std::sin(t)};
}

TEST(Exposure, doubles_light_with_each_stop) {
    expect_near(edit_with("exposure", {{"stops", 2.0}}, "linear")({.1, .2, -.3}), {.4, .8, -1.2},
                1e-15);
    // In camera log a stop is a step: LogC3 EI 800 has c log10(2) = .0744 to the stop.
    const Transform log = edit_with("exposure", {{"stops", 1.0}}, "logc3");
    EXPECT_NEAR(log({.6, .6, .6}).g - .6, 0.24719 * std::log10(2), 1e-3);
}

TEST(WhiteBalance, warms_with_kelvin_and_turns_magenta_with_tint) {
    const RgbD warm = edit_with("white-balance", {{"temperature", 9000.0}}, "linear")({.5, .5, .5});
    EXPECT_GT(warm.r, warm.g);
    EXPECT_GT(warm.g, warm.b);
    const RgbD cool = edit_with("white-balance", {{"temperature", 4000.0}}, "linear")({.5, .5, .5});
    EXPECT_LT(cool.r, cool.g);
    EXPECT_LT(cool.g, cool.b);
    const RgbD magenta = edit_with("white-balance", {{"tint", 20.0}}, "linear")({.5, .5, .5});
    EXPECT_GT(magenta.r, magenta.g);
    EXPECT_GT(magenta.b, magenta.g);
}

TEST(WhiteBalance, keeps_the_luminance_of_grey) {
    for (const char* const encoding : {"linear", "linear/rec2020"}) {
        const auto luminance = rgb_to_xyz(encoding_named(encoding)->primaries()).m[1];
        for (const double kelvin : {2000.0, 2800.0, 5000.0, 9000.0, 15000.0}) {
            for (const double tint : {-30.0, 0.0, 50.0}) {
                const RgbD grey =
                    edit_with("white-balance", {{"temperature", kelvin}, {"tint", tint}},
                              encoding)({.18, .18, .18});
                EXPECT_NEAR(luminance[0] * grey.r + luminance[1] * grey.g + luminance[2] * grey.b,
                            .18, 1e-12)
                    << encoding << ' ' << kelvin << ' ' << tint;
            }
        }
    }
}

TEST(WhiteBalance, says_where_it_takes_grey_out_of_the_gamut_and_what_keeps_it_inside) {
    Recipe recipe;
    const auto note = [&recipe](double kelvin, double tint) {
        recipe.operations = {{op_named("white-balance"), {kelvin, tint}, true}};
        const std::vector<std::string> notes = notes_of(recipe);
        return notes.empty() ? std::string() : notes.front();
    };
    EXPECT_EQ(note(2600, 0), "");
    EXPECT_EQ(note(15000, 0), "");
    EXPECT_NE(note(2000, 0).find("red of white is -0."), std::string::npos) << note(2000, 0);
    EXPECT_NE(note(2000, 0).find("from 2521 K"), std::string::npos) << note(2000, 0);
    EXPECT_LT(edit_with("white-balance", {{"temperature", 2510.0}}, "linear")({1, 1, 1}).r, 0);
    EXPECT_GT(edit_with("white-balance", {{"temperature", 2521.0}}, "linear")({1, 1, 1}).r, 0);
    recipe.input = require_encoding("linear/rec2020");
    EXPECT_EQ(note(2000, 0), "");
}

TEST(Contrast, turns_about_the_code_of_middle_grey_unless_a_pivot_is_given) {
    for (const char* const name : {"srgb", "linear", "logc3", "pq"}) {
        const double grey = require_encoding(name).encode(0.18);
        const RgbD kept = edit_with("contrast", {{"amount", 1.5}}, name)({grey, grey, grey});
        EXPECT_NEAR(kept.g, grey, 1e-12) << name;
        const RgbD moved =
            edit_with("contrast", {{"amount", 1.5}, {"pivot", 0.25}}, name)({.5, .25, 0});
        expect_near(moved, {.625, .25, -.125}, 1e-12);
    }
}

TEST(WhiteBalance, of_opposite_lights_nearly_cancels) {
    const Transform there = edit_with("white-balance", {{"temperature", 7500.0}}, "linear");
    const RgbD once = there({.4, .5, .6});
    // 7500 K lies as far from 6504 K as 5742 K does on the reciprocal scale, 20.4 mired.
    const RgbD back = edit_with("white-balance", {{"temperature", 5742.0}}, "linear")(once);
    expect_near(back, {.4, .5, .6}, 0.01);
}

TEST(LiftGammaGain, lift_moves_black_and_holds_white) {
    const Transform lift = edit_with("lift-gamma-gain", {{"lift", RgbD{.1, 0, -.1}}});
    expect_near(lift({0, 0, 0}), {.1, 0, -.1}, 1e-15);
    expect_near(lift({1, 1, 1}), {1, 1, 1}, 1e-15);
    const Transform gamma = edit_with("lift-gamma-gain", {{"gamma", RgbD{2, 1, .5}}});
    expect_near(gamma({.25, .25, .5}), {.5, .25, .25}, 1e-13);
    expect_near(gamma({-.25, -.25, -.5}), {-.5, -.25, -.25}, 1e-13);
}

TEST(Saturation, uses_rec709_weights_on_code_values) {
    const double luma = 0.2126 * .2 + 0.7152 * .4 + 0.0722 * .6;
    expect_near(edit_with("saturation", {{"amount", 0.0}})({.2, .4, .6}), {luma, luma, luma},
                1e-15);
    expect_near(edit_with("saturation", {{"amount", 2.0}})({.2, .4, .6}),
                {2 * .2 - luma, 2 * .4 - luma, 2 * .6 - luma}, 1e-15);
}

TEST(SaturationPerceptual, scales_chroma_and_keeps_lightness_and_hue) {
    const Transform edit = edit_with("saturation-perceptual", {{"amount", 1.5}}, "linear");
    const RgbD got = in_oklab(edit, {.6, .08, -.04});
    expect_near(got, {.6, .12, -.06}, 1e-13);
}

TEST(Vibrance, moves_pale_colors_more_than_vivid_ones) {
    const Transform edit = edit_with("vibrance", {{"amount", 0.5}}, "linear");
    const auto factor = [&](double C) { return chroma(in_oklab(edit, {.6, C, 0})) / C; };
    EXPECT_GT(factor(.02), 1.4);
    EXPECT_LT(factor(.3), 1.01);
    EXPECT_GT(factor(.3), 1);
}

TEST(Highlights, bring_white_to_one_and_leave_what_lies_below_the_start) {
    for (const double bleach : {0.0, 1.0}) {
        const Transform edit =
            edit_with("highlights", {{"white", 8.0}, {"start", 0.4}, {"bleach", bleach}}, "linear");
        expect_near(edit({8, 8, 8}), {1, 1, 1}, 1e-12);
        expect_near(edit({.4, .3, .1}), {.4, .3, .1}, 1e-15);
        const double slope = (edit({.4001, .4001, .4001}).g - .4) / 1e-4;
        EXPECT_NEAR(slope, 1, 1e-3);
    }
    const Transform keeps = edit_with("highlights", {{"white", 8.0}, {"bleach", 0.0}}, "linear");
    const RgbD c = keeps({6, 3, 1.5});
    EXPECT_NEAR(c.g / c.r, .5, 1e-12);
    EXPECT_NEAR(c.b / c.r, .25, 1e-12);
}

TEST(Curves, pass_through_their_knots_and_go_on_with_slope_1) {
    const Transform edit = edit_with("curves", {{"master", Knots{{0, .1}, {.5, .6}, {1, .9}}},
                                                {"blue", Knots{{0, 0}, {1, .5}}}});
    EXPECT_NEAR(edit({.5, .5, .5}).r, .6, 1e-15);
    EXPECT_NEAR(edit({1.5, 0, 0}).r, 1.4, 1e-15);
    EXPECT_NEAR(edit({-.5, 0, 0}).r, -.4, 1e-15);
    EXPECT_NEAR(edit({.5, .5, .5}).b, .3, 1e-15);
}

TEST(SplitToning, tints_shadows_and_highlights_and_leaves_black_and_white) {
    const Transform edit = edit_with("split-toning", {{"shadow_hue", 240.0},
                                                      {"shadow_amount", 1.0},
                                                      {"highlight_hue", 40.0},
                                                      {"highlight_amount", 1.0}});
    expect_near(edit({0, 0, 0}), {0, 0, 0}, 1e-6);
    expect_near(edit({1, 1, 1}), {1, 1, 1}, 1e-6);
    const RgbD dark = edit({.1, .1, .1}), light = edit({.8, .8, .8});
    EXPECT_GT(dark.b, dark.r);
    EXPECT_GT(light.r, light.b);
}

TEST(HueCurves, act_on_their_hue_and_leave_the_opposite_one) {
    const Knots at_green{{60, 1}, {90, 1}, {120, 2}, {150, 1}, {180, 1}};
    const Transform sat = edit_with("hue-vs-sat", {{"curve", at_green}}, "linear");
    EXPECT_NEAR(chroma(in_oklab(sat, lab_at(.6, .1, 120))), .2, 1e-9);
    EXPECT_NEAR(chroma(in_oklab(sat, lab_at(.6, .1, 300))), .1, 1e-9);
    const Transform lum = edit_with("hue-vs-lum", {{"curve", at_green}}, "linear");
    EXPECT_GT(in_oklab(lum, lab_at(.5, .2, 120)).r, .9);
    EXPECT_NEAR(in_oklab(lum, lab_at(.5, .2, 300)).r, .5, 1e-9);
    EXPECT_NEAR(in_oklab(lum, {.5, 0, 0}).r, .5, 1e-9);
    const Transform turn =
        edit_with("hue-vs-hue", {{"curve", Knots{{60, 0}, {120, 30}, {180, 0}}}}, "linear");
    const RgbD before = lab_at(.6, .1, 120), after = in_oklab(turn, before);
    const double angle = std::atan2(after.b, after.g) - std::atan2(before.b, before.g);
    EXPECT_NEAR(angle * 180 / std::numbers::pi, 30, 1e-6);
}

TEST(HueRange, edits_its_band_and_nothing_else) {
    const Transform edit = edit_with("hue-range",
                                     {{"centre", 350.0},
                                      {"width", 40.0},
                                      {"softness", 20.0},
                                      {"saturation", 0.5},
                                      {"luminance", 1.2}},
                                     "linear");
    // The band runs through red: from 330 over 0 to 10, and fades out 20 degrees further.
    // Luminance counts by the weight of a chroma of .2 as a hue, C^2 / (C^2 + .03225^2) = .9747.
    EXPECT_NEAR(in_oklab(edit, lab_at(.5, .2, 5)).r, .5 * (1 + .2 * .9747), 1e-3);
    EXPECT_NEAR(chroma(in_oklab(edit, lab_at(.5, .2, 5))), .1 * (1 + .2 * .9747), 1e-3);
    expect_near(in_oklab(edit, lab_at(.5, .1, 40)), lab_at(.5, .1, 40), 1e-9);
    expect_near(in_oklab(edit, lab_at(.5, .1, 300)), lab_at(.5, .1, 300), 1e-9);
}

TEST(LuminanceAndSaturationCurves, follow_their_axis) {
    const Transform lum = edit_with("lum-vs-sat", {{"curve", Knots{{.2, 0}, {.8, 2}}}}, "linear");
    EXPECT_NEAR(chroma(in_oklab(lum, {.1, .1, 0})), 0, 1e-9);
    EXPECT_NEAR(chroma(in_oklab(lum, {.9, .1, 0})), .2, 1e-9);
    const Transform sat = edit_with("sat-vs-sat", {{"curve", Knots{{.2, 1}, {.6, .5}}}}, "linear");
    EXPECT_NEAR(chroma(in_oklab(sat, {.5, .3225 * .1, 0})), .03225, 1e-9);
    EXPECT_NEAR(chroma(in_oklab(sat, {.5, .3225 * .8, 0})), .3225 * .4, 1e-9);
    const Transform dark = edit_with("sat-vs-lum", {{"curve", Knots{{0, 1}, {.5, .8}}}}, "linear");
    EXPECT_NEAR(in_oklab(dark, {.5, .3, 0}).r, .4, 1e-9);
    EXPECT_NEAR(in_oklab(dark, {.5, 0, 0}).r, .5, 1e-9);
    const Transform lift =
        edit_with("lum-vs-lum", {{"curve", Knots{{.3, 1.5}, {.7, 1}}}}, "linear");
    EXPECT_NEAR(in_oklab(lift, {.2, .02, .01}).r, .3, 1e-9);
    EXPECT_NEAR(in_oklab(lift, {.8, .02, .01}).r, .8, 1e-9);
}

} // namespace
} // namespace lutlib
