// What the window edits, without a window: history, operators' order, knots, sides and files.
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/transform.h"
#include "preview/editor/commands.h"
#include "preview/editor/knots.h"
#include "preview/editor/look_baker.h"
#include "preview/effects/effect.h"
#include "preview/look/cube_settings.h"
#include "preview/look/recipe_table.h"
#include "preview/scene/camera_settings.h"
#include "preview/scene/light_controls.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;
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

struct Folder {
    Folder()
        : path(fs::temp_directory_path() /
               ("lutpreview_test_" +
                std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()))) {
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    std::string file(const std::string& name) const { return (path / name).string(); }
    fs::path path;
};

TEST(History, undoes_and_redoes_a_change_of_every_operator_and_of_the_view) {
    History history(initial_state());
    std::vector<State> states{history.draft()};
    for (const lutlib::Op* op : lutlib::ops()) {
        add_operation(history.draft().recipe, *op);
        EXPECT_TRUE(history.settle()) << op->name;
        states.push_back(history.draft());
    }
    for (const EffectInfo& row : effects) {
        history.draft().without.set(row.effect, true);
        EXPECT_TRUE(history.settle()) << row.name;
        states.push_back(history.draft());
    }
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        row.of(history.draft()) = static_cast<float>(row.max);
        EXPECT_TRUE(history.settle()) << row.flag;
        states.push_back(history.draft());
    }
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        row.of(history.draft().orbit) = static_cast<float>(row.max);
        EXPECT_TRUE(history.settle()) << row.flag;
        states.push_back(history.draft());
    }
    for (const NumberRow<CubeView>& row : cube_numbers()) {
        row.of(history.draft().cube.view) = static_cast<float>(row.max);
        EXPECT_TRUE(history.settle()) << row.flag;
        states.push_back(history.draft());
    }
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        row.of(history.draft().cube.view) = true;
        EXPECT_TRUE(history.settle()) << row.flag;
        states.push_back(history.draft());
    }
    for (const PostEffect* effect : post_effects()) {
        put_use(history.draft().effects, usual_use(*effect));
        EXPECT_TRUE(history.settle()) << effect->name;
        states.push_back(history.draft());
        history.draft().effects.back().values.front() = 0.5;
        EXPECT_TRUE(history.settle()) << effect->name;
        states.push_back(history.draft());
    }
    for (const LightControl& control : light_controls()) {
        std::vector<PointLight>& lights = history.draft().lights;
        lights.resize(2);
        control.set(lights[1], glm::vec3(control.kind == LightControl::Kind::flag
                                             ? 1 - control.get(lights[1]).x
                                             : control.max / 2,
                                         control.max, control.max));
        history.settle();
        EXPECT_FALSE(history.draft() == states.back()) << control.name;
        states.push_back(history.draft());
    }
    history.draft().split = 0.25F;
    history.draft().orbit.azimuth = 12;
    history.draft().sides[0].source = SideSource::baked;
    history.settle();
    states.push_back(history.draft());
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        EXPECT_TRUE(history.undo());
        EXPECT_TRUE(history.draft() == states[i - 1]) << i;
    }
    EXPECT_FALSE(history.undo());
    for (std::size_t i = 1; i < states.size(); ++i) {
        EXPECT_TRUE(history.redo());
        EXPECT_TRUE(history.draft() == states[i]) << i;
    }
    EXPECT_FALSE(history.redo());
}

TEST(History, brings_back_which_scopes_are_seen_and_how_the_cube_is_turned) {
    History history(initial_state());
    history.draft().scopes_seen.seen[2] = true;
    EXPECT_TRUE(history.settle());
    history.draft().scopes_seen.logarithmic = false;
    EXPECT_TRUE(history.settle());
    history.draft().cube.view.turn += 30;
    EXPECT_TRUE(history.settle());
    const State last = history.draft();
    for (int step = 0; step < 3; ++step) {
        EXPECT_TRUE(history.undo());
    }
    EXPECT_TRUE(history.draft() == initial_state());
    while (history.redo()) {
    }
    EXPECT_TRUE(history.draft() == last);
}

TEST(History, brings_back_what_the_picture_is_encoded_with) {
    History history(initial_state());
    history.draft().picture.encoding = *lutlib::encoding_named("logc3");
    EXPECT_TRUE(history.settle());
    history.draft().picture.convert = false;
    EXPECT_TRUE(history.settle());
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().picture, PictureCodes{*lutlib::encoding_named("logc3")});
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().picture, PictureCodes{});
}

TEST(History, makes_one_step_of_a_whole_gesture) {
    History history(initial_state());
    for (int i = 1; i <= 100; ++i) {
        history.draft().exposure = 0.01F * static_cast<float>(i);
    }
    history.settle();
    EXPECT_FALSE(history.settle());
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().exposure, 0);
    EXPECT_FALSE(history.can_undo());
}

TEST(History, forgets_what_could_be_redone_after_a_new_change) {
    History history(initial_state());
    history.draft().exposure = 1;
    history.settle();
    history.undo();
    history.draft().exposure = 2;
    history.settle();
    EXPECT_FALSE(history.redo());
    history.undo();
    EXPECT_EQ(history.draft().exposure, 0);
}

TEST(History, settles_an_open_change_before_it_undoes_it) {
    History history(initial_state());
    history.draft().split = 0.1F;
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().split, 0.5F);
    EXPECT_TRUE(history.redo());
    EXPECT_EQ(history.draft().split, 0.1F);
}

TEST(History, keeps_the_newest_steps_of_a_long_session) {
    History history(initial_state());
    for (std::size_t i = 1; i <= History::max_steps + 10; ++i) {
        history.draft().exposure = static_cast<float>(i);
        history.settle();
    }
    std::size_t steps = 0;
    while (history.undo()) {
        ++steps;
    }
    EXPECT_EQ(steps, History::max_steps - 1);
    EXPECT_EQ(history.draft().exposure, 11);
}

TEST(Operations, move_to_any_place_and_keep_the_others_in_order) {
    for (std::size_t from = 0; from < 4; ++from) {
        for (std::size_t to = 0; to < 4; ++to) {
            lutlib::Recipe recipe;
            std::vector<const lutlib::Op*> expected;
            for (std::size_t i = 0; i < 4; ++i) {
                add_operation(recipe, *lutlib::ops()[i]);
                if (i != from) {
                    expected.push_back(lutlib::ops()[i]);
                }
            }
            expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(to),
                            lutlib::ops()[from]);
            move_operation(recipe, from, to);
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_EQ(recipe.operations[i].op, expected[i]) << from << " to " << to;
            }
        }
    }
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

TEST(Side, is_baked_for_every_engine_and_every_source) {
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("saturation"));
    state.recipe.operations[0].values[0] = 0.25;
    for (const SideSourceInfo& info : side_sources) {
        for (const GpuLookup* engine : engine_lookups()) {
            Side side;
            side.source = info.source;
            side.engine = engine;
            const LoadedLook look = look_of(state.recipe, side);
            const bool shows =
                info.source == SideSource::recipe || info.source == SideSource::baked;
            EXPECT_EQ(look.skip_reason.empty(), shows) << info.name;
            EXPECT_EQ(look.data.lookup == engine, info.source == SideSource::baked);
        }
    }
}

TEST(LookBaker, ends_with_the_newest_request_of_many) {
    LookBaker baker([] {});
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    for (int i = 0; i <= 20; ++i) {
        state.recipe.operations[0].values[0] = 0.1 * i;
        baker.request({state.recipe, state.sides});
    }
    const RecipeTable table = *measured_table(state.recipe);
    const LoadedLook newest = measured_look(table, *gpu_lookup_named("tetrahedral"));
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    bool found = false;
    while (!found && std::chrono::steady_clock::now() < give_up) {
        if (const std::optional<BakedLooks> looks = baker.take()) {
            found = looks->sides[1].note == newest.note &&
                    looks->sides[1].data.volume.bytes == newest.data.volume.bytes &&
                    looks->sides[1].data.picture.bytes == newest.data.picture.bytes;
        }
    }
    EXPECT_TRUE(found);
    EXPECT_FALSE(baker.is_busy());
}

TEST(LookBaker, bakes_at_once_and_measures_when_nothing_follows) {
    LookBaker baker([] {});
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("saturation"));
    state.recipe.operations[0].values[0] = 0.5;
    baker.request({state.recipe, state.sides});
    std::vector<std::string> notes;
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (notes.size() < 2 && std::chrono::steady_clock::now() < give_up) {
        if (const std::optional<BakedLooks> looks = baker.take()) {
            notes.push_back(looks->sides[1].note);
        }
    }
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0], "");
    EXPECT_NE(notes[1].find("of the look itself"), std::string::npos) << notes[1];
}

TEST(RecipeTable, is_fine_enough_that_no_difference_is_seen) {
    lutlib::Recipe recipe;
    add_operation(recipe, *lutlib::op_named("saturation"));
    recipe.operations[0].values[0] = 0.4;
    const RecipeTable mild = *measured_table(recipe);
    EXPECT_LT(mild.max_error, visible_difference);
    EXPECT_EQ(mild.nodes, 33);
    // Light that is clipped makes a kink, which lies between nodes.
    lutlib::Recipe bright;
    add_operation(bright, *lutlib::op_named("exposure"));
    bright.operations[0].values[0] = 2.0;
    const RecipeTable steep = *measured_table(bright);
    EXPECT_GT(steep.nodes, 33);
    EXPECT_LT(steep.max_error, visible_difference);
}

TEST(RecipeTable, is_measured_as_the_recipe_and_the_table_differ) {
    lutlib::Recipe recipe;
    add_operation(recipe, *lutlib::op_named("exposure"));
    recipe.operations[0].values[0] = 1.0;
    const RecipeTable table = *measured_table(recipe);
    const lutlib::Transform exact = lutlib::Transform::of(recipe);
    double largest = 0;
    for (int i = 0; i <= 4000; ++i) {
        const double v = i / 4000.0;
        const lutlib::RgbD in{v, 0.5 * v, 1 - v};
        const lutlib::Rgb at = lutlib::to_float(in);
        const lutlib::Difference difference = lutlib::difference_of(
            {at}, {exact(in)},
            {lutlib::evaluate_exact(table.lut, in, lutlib::Interpolation::tetrahedral)},
            lutlib::srgb());
        largest = std::max(largest, difference.delta_e_2000.max);
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(largest, 1.2 * table.max_error); // a line meets places between the dense colours
}

TEST(RecipeTable, stops_when_it_is_told) {
    lutlib::Recipe recipe;
    add_operation(recipe, *lutlib::op_named("exposure"));
    int asked = 0;
    EXPECT_FALSE(measured_table(recipe, [&] { return ++asked == 3; }));
    EXPECT_EQ(asked, 3);
}

TEST(Commands, save_a_recipe_that_opens_as_it_was) {
    const Folder folder;
    State state = initial_state();
    for (const lutlib::Op* op : lutlib::ops()) {
        add_operation(state.recipe, *op);
    }
    state.recipe.title = "All";
    save_recipe(state, folder.file("all.json"));
    State opened = initial_state();
    const auto saved = lutlib::io::Look::open_if_look(folder.file("all.json"));
    ASSERT_TRUE(saved);
    open_look(opened, *saved);
    EXPECT_TRUE(opened == state);
}

TEST(Commands, make_an_exported_lut_the_base_of_a_new_recipe) {
    const Folder folder;
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    state.recipe.operations[0].values[0] = 0.5;
    EXPECT_NE(export_lut(state, folder.file("look.cube")), "");
    State opened = initial_state();
    open_look(opened, lutlib::io::Look::open(folder.file("look.cube")));
    ASSERT_NE(opened.recipe.base_lut, nullptr);
    EXPECT_TRUE(opened.recipe.operations.empty());
    const lutlib::RgbD in{0.25, 0.5, 0.75};
    const lutlib::RgbD want = lutlib::Transform::of(state.recipe)(in);
    const lutlib::RgbD got = lutlib::Transform::of(opened.recipe)(in);
    // Between the 33 nodes of the file.
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(got[c], want[c], 2e-3);
    }
}

} // namespace
} // namespace preview::editor
