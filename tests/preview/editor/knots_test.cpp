// Curves' knots, as the editor adds, moves and removes them.
#include "preview/editor/knots.h"

#include "lutlib/ops/op.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

using lutlib::Knot;
using lutlib::Knots;
using lutlib::Parameter;

std::vector<const Parameter*> curve_parameters() {
    std::vector<const Parameter*> out;
    for (const lutlib::Op* op : lutlib::ops()) {
        for (const Parameter& parameter : op->parameters) {
            if (parameter.kind == lutlib::ParameterKind::curve) {
                out.push_back(&parameter);
            }
        }
    }
    return out;
}

Knot middle_of(const CurveView& view) {
    return {(view.x_min + view.x_max) / 2, (view.y_min + view.y_max) / 2};
}

TEST(Knots, stay_valid_and_sorted_however_they_are_added_moved_and_removed) {
    for (const Parameter* parameter : curve_parameters()) {
        SCOPED_TRACE(std::string(parameter->flag));
        Knots knots;
        for (const double share : {0.5, 0.0, 1.0, 0.25, 0.25, -3.0, 9.0}) {
            const CurveView view = view_of(*parameter, knots);
            const std::size_t at = add_knot(*parameter, knots,
                                            {view.x_min + share * (view.x_max - view.x_min),
                                             view.y_min + share * (view.y_max - view.y_min)});
            ASSERT_LT(at, knots.size());
            move_knot(*parameter, knots, at, {1e6 * (share - 0.4), -1e6});
            EXPECT_EQ(lutlib::problem_with(*parameter, knots), "");
            for (std::size_t i = 1; i < knots.size(); ++i) {
                EXPECT_LT(knots[i - 1].x, knots[i].x);
            }
        }
        while (!knots.empty()) {
            remove_knot(*parameter, knots, knots.size() - 1);
        }
    }
}

TEST(Knots, at_both_ends_of_a_circle_are_one) {
    for (const Parameter* parameter : curve_parameters()) {
        if (!parameter->axis.periodic) {
            continue;
        }
        const double low = parameter->min, high = parameter->max;
        Knots knots{{0, low}, {180, high}, {360, low}};
        move_knot(*parameter, knots, 0, {0, high});
        EXPECT_EQ(knots.back().y, high) << parameter->flag;
        knots = {{10, low}, {180, high}, {360, low}};
        add_knot(*parameter, knots, {0, high});
        EXPECT_EQ(lutlib::problem_with(*parameter, knots), "") << parameter->flag;
    }
}

TEST(Knots, lie_inside_what_the_editor_shows) {
    for (const Parameter* parameter : curve_parameters()) {
        Knots knots;
        add_knot(*parameter, knots, {parameter->axis.max, parameter->max});
        const CurveView view = view_of(*parameter, knots);
        for (const Knot& knot : knots) {
            EXPECT_LE(view.x_min, knot.x);
            EXPECT_GE(view.x_max, knot.x);
            EXPECT_LE(view.y_min, knot.y);
            EXPECT_GE(view.y_max, knot.y);
        }
    }
}

TEST(Knots, leave_a_neutral_curve_neutral_when_the_first_one_is_set_on_it) {
    for (const Parameter* parameter : curve_parameters()) {
        SCOPED_TRACE(std::string(parameter->flag));
        Knots knots;
        const CurveView view = view_of(*parameter, knots);
        const double x = middle_of(view).x;
        add_knot(*parameter, knots, {x, parameter->axis.diagonal ? x : parameter->fallback});
        const lutlib::Curve curve = lutlib::curve_of(*parameter, knots);
        for (int i = 0; i <= 64; ++i) {
            const double at = view.x_min + (view.x_max - view.x_min) * i / 64;
            // A cubic through knots on a line rounds in the last places.
            EXPECT_NEAR(curve(at), parameter->axis.diagonal ? at : parameter->fallback, 1e-9);
        }
    }
}

TEST(Knots, become_none_again_when_the_only_change_is_deleted) {
    for (const Parameter* parameter : curve_parameters()) {
        Knots knots;
        const CurveView view = view_of(*parameter, knots);
        const std::size_t at = add_knot(*parameter, knots, {middle_of(view).x, view.y_max});
        remove_knot(*parameter, knots, at);
        EXPECT_TRUE(knots.empty()) << parameter->flag;
    }
}

TEST(Knots, are_caught_within_reach_only_and_the_nearest_first) {
    const CurveView view{0, 360, 0, 2};
    const Knots knots{{100, 1}, {110, 1}};
    const Knot reach{10.0 / 400, 10.0 / 140};
    EXPECT_EQ(knot_at(view, knots, {104, 1}, reach), 0U);
    EXPECT_EQ(knot_at(view, knots, {106, 1}, reach), 1U);
    EXPECT_EQ(knot_at(view, knots, {104, 1.5}, reach), std::nullopt);
    EXPECT_EQ(knot_at(view, {}, {104, 1}, reach), std::nullopt);
}

} // namespace
} // namespace preview::editor
