#include "preview/editor/picked.h"

#include "lutlib/color/oklab.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

using lutlib::Knots;
using lutlib::Operation;
using lutlib::RgbD;

void expect_near(RgbD got, RgbD want, double bound) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(got[i], want[i], bound);
    }
}

RgbD decoded(const lutlib::Encoding& encoding, RgbD codes) {
    return {encoding.decode(codes.r), encoding.decode(codes.g), encoding.decode(codes.b)};
}

TEST(Picked, colours_go_through_the_operators_before_into_the_operators_space) {
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("offset"));
    state.recipe.operations[0].values[0] = RgbD{0.1, 0, -0.1};
    add_operation(state.recipe, *lutlib::op_named("saturation"));
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    add_operation(state.recipe, *lutlib::op_named("hue-vs-hue"));
    add_operation(state.recipe, *lutlib::op_named("contrast"));
    state.recipe.operations[4].values[0] = 3.0; // behind all that is picked for
    const Probe probe{.before = {0.5, 0.4, 0.3}, .a = {}, .b = {}, .light = {}};
    expect_near(color_into(state, probe, 0), {0.5, 0.4, 0.3}, 1e-12);
    const RgbD shifted{0.6, 0.4, 0.2};
    expect_near(color_into(state, probe, 1), shifted, 1e-12);
    const RgbD light = decoded(lutlib::srgb(), shifted);
    expect_near(color_into(state, probe, 2), light, 1e-12);
    // Matrices of another precision.
    expect_near(color_into(state, probe, 3), lutlib::oklab_from_linear(light), 1e-6);
    state.recipe.operations[0].enabled = false;
    expect_near(color_into(state, probe, 1), {0.5, 0.4, 0.3}, 1e-12);
}

TEST(Picked, colours_are_those_that_a_log_look_gets_before_the_tone_map) {
    State state = initial_state();
    state.recipe.input = lutlib::require_encoding("logc3/rec709");
    state.recipe.states_input = true;
    state.recipe.output = lutlib::srgb();
    state.picture.has_light = true;
    add_operation(state.recipe, *lutlib::op_named("offset"));
    const Probe probe{.before = {0.9, 0.9, 0.9}, .a = {}, .b = {}, .light = {0.18, 0.5, 2}};
    const RgbD want{state.recipe.input.encode(0.18), state.recipe.input.encode(0.5),
                    state.recipe.input.encode(2)};
    expect_near(color_into(state, probe, 0), want, 1e-9);
}

TEST(Picked, places_on_axes_are_within_them_and_where_the_operator_looks) {
    const RgbD lab = lutlib::oklab_from_linear({0.6, 0.1, 0.05});
    const Operation hue = default_operation(*lutlib::op_named("hue-vs-sat"));
    EXPECT_DOUBLE_EQ(place_on_axis(hue, 0, lab), lutlib::dial_hue(lab.g, lab.b));
    const Operation luminance = default_operation(*lutlib::op_named("lum-vs-sat"));
    EXPECT_DOUBLE_EQ(place_on_axis(luminance, 0, lab), lab.r);
    const Operation saturation = default_operation(*lutlib::op_named("sat-vs-lum"));
    EXPECT_DOUBLE_EQ(place_on_axis(saturation, 0, lab),
                     std::hypot(lab.g, lab.b) / lutlib::srgb_chroma);
    Operation curves = default_operation(*lutlib::op_named("curves"));
    const RgbD codes{0.2, 0.4, 0.6};
    EXPECT_NEAR(place_on_axis(curves, 0, codes), 0.2126 * 0.2 + 0.7152 * 0.4 + 0.0722 * 0.6, 1e-12);
    EXPECT_DOUBLE_EQ(place_on_axis(curves, 1, codes), 0.2);
    // Behind the master curve, which here adds a tenth.
    curves.values[0] = Knots{{0, 0.1}, {1, 1.1}};
    EXPECT_NEAR(place_on_axis(curves, 3, codes), 0.7, 1e-12);
    for (const lutlib::Op* op : lutlib::ops()) {
        for (std::size_t i = 0; i < op->parameters.size(); ++i) {
            const lutlib::CurveAxis& axis = op->parameters[i].axis;
            if (op->parameters[i].kind == lutlib::ParameterKind::curve) {
                const double x = place_on_axis(default_operation(*op), i, {90, 90, 90});
                EXPECT_GE(x, axis.min) << op->name;
                EXPECT_LE(x, axis.max) << op->name;
            }
        }
    }
}

TEST(Picked, whites_and_hues_become_the_operators_values) {
    for (const Picker& picker : pickers()) {
        const lutlib::Op* const op = lutlib::op_named(picker.op);
        ASSERT_NE(op, nullptr) << picker.op;
        Operation operation = default_operation(*op);
        EXPECT_FALSE(picker.put(operation, {0, 0, 0}, {})) << picker.op;
        EXPECT_TRUE(is_identity(operation)) << picker.op;
        const RgbD light{0.3, 0.25, 0.2};
        const bool is_light = op->space == lutlib::Space::linear;
        const RgbD color = is_light ? light : lutlib::oklab_from_linear(light);
        EXPECT_TRUE(picker.put(operation, color, {})) << picker.op;
        EXPECT_FALSE(is_identity(operation)) << picker.op;
        for (std::size_t i = 0; i < operation.values.size(); ++i) {
            EXPECT_EQ(problem_with(op->parameters[i], operation.values[i]), "");
        }
        if (is_light) {
            const RgbD grey = op->compile(operation.values, {})(light);
            // Kelvins are rounded to whole ones.
            EXPECT_NEAR(grey.r / grey.g, 1, 1e-3);
            EXPECT_NEAR(grey.b / grey.g, 1, 1e-3);
        }
    }
}

} // namespace
} // namespace preview::editor
