// What the window edits, without a window: history, operators' order and files.
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/editor/commands.h"
#include "preview/editor/knots.h"
#include "preview/editor/look_baker.h"
#include "preview/editor/look_export.h"
#include "preview/effects/effect.h"
#include "preview/look/cube_settings.h"
#include "preview/scene/camera_settings.h"
#include "preview/scene/light_controls.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;

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
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        row.of(history.draft().surroundings) = static_cast<float>(row.max);
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

TEST(History, goes_to_an_inserted_step_and_keeps_what_can_be_redone_behind_it) {
    History history(initial_state());
    for (const float exposure : {1.0F, 2.0F}) {
        history.draft().exposure = exposure;
        history.settle();
    }
    history.undo();
    history.draft().split = 0.25F; // not settled
    history.undo();
    history.redo();
    State next = history.draft();
    next.exposure = 3;
    history.insert(next);
    EXPECT_EQ(history.draft().exposure, 3);
    EXPECT_FALSE(history.can_redo()) << "the split was a change, behind which nothing is redone";
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().split, 0.25F);
    EXPECT_TRUE(history.undo());
    next.exposure = 4;
    history.insert(next);
    std::vector<float> redone;
    while (history.redo()) {
        redone.push_back(history.draft().exposure);
    }
    EXPECT_EQ(redone, (std::vector<float>{1, 3}));
}

TEST(History, keeps_its_place_when_a_step_is_inserted_into_a_full_one) {
    History history(initial_state());
    for (std::size_t i = 1; i < History::max_steps; ++i) {
        history.draft().exposure = static_cast<float>(i);
        history.settle();
    }
    history.undo();
    State next = history.draft();
    next.exposure = 0.5F;
    history.insert(next);
    EXPECT_EQ(history.draft().exposure, 0.5F);
    EXPECT_TRUE(history.redo());
    EXPECT_EQ(history.draft().exposure, History::max_steps - 1);
    EXPECT_FALSE(history.redo());
    EXPECT_TRUE(history.undo());
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().exposure, History::max_steps - 2);
}

TEST(History, changes_the_world_in_every_state_and_makes_no_step_of_it) {
    History history(initial_state());
    history.draft().exposure = 1;
    history.settle();
    history.draft().exposure = 2; // not settled
    history.change_all([](State& state) { state.base_path = "new"; });
    EXPECT_EQ(history.draft().base_path, "new");
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().exposure, 1);
    EXPECT_EQ(history.draft().base_path, "new");
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.draft().base_path, "new");
    EXPECT_FALSE(history.undo());
}

TEST(Recipe, of_another_adaptation_is_another) {
    lutlib::Recipe one, other;
    other.adaptation = &lutlib::cat02;
    EXPECT_TRUE(same(one, one));
    EXPECT_FALSE(same(one, other));
    EXPECT_FALSE(same(LookRequest{one, {}}, LookRequest{other, {}})) << "it would not be baked";
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

TEST(Commands, save_a_recipe_that_opens_as_it_was) {
    const Folder folder;
    History history(initial_state());
    State& state = history.draft();
    for (const lutlib::Op* op : lutlib::ops()) {
        add_operation(state.recipe, *op);
    }
    state.recipe.title = "All";
    EXPECT_TRUE(is_unsaved(state));
    save_recipe(history, folder.file("all.json"));
    EXPECT_FALSE(is_unsaved(state));
    State opened = initial_state();
    const auto saved = lutlib::io::Look::open_if_look(folder.file("all.json"));
    ASSERT_TRUE(saved);
    open_look(opened, *saved);
    EXPECT_TRUE(opened == state);
    EXPECT_FALSE(is_unsaved(opened));
}

TEST(Commands, that_undo_what_was_saved_leave_it_unsaved) {
    const Folder folder;
    History history(initial_state());
    add_operation(history.draft().recipe, *lutlib::op_named("exposure"));
    history.settle();
    save_recipe(history, folder.file("a.json"));
    history.settle();
    history.undo();
    history.undo();
    EXPECT_TRUE(history.draft().recipe.operations.empty());
    EXPECT_TRUE(is_unsaved(history.draft()));
    history.redo();
    history.redo();
    EXPECT_FALSE(is_unsaved(history.draft()));
}

TEST(Commands, make_an_exported_lut_the_base_of_a_new_recipe) {
    const Folder folder;
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    state.recipe.operations[0].values[0] = 0.5;
    write(prepare_lut(state, {}, folder.file("look.cube")));
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
