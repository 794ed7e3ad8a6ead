// What the palette offers, and what it finds.
#include "preview/panels/palette.h"

#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/look/look_standing.h"
#include "preview/panels/look_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace preview::panels {
namespace {

/// As the program fills it when a model is shown.
Ui some_ui() {
    Ui ui(initial_state());
    for (const DebugView& view : debug_views()) {
        ui.facts.debug_views.push_back({view.name, view.help});
    }
    ui.facts.cameras = {{"door", {}}};
    ui.cameras.kept = {{"kept 1", {}}};
    ui.recent = {"/looks/last.cube"};
    return ui;
}

TEST(Palette, offers_every_command_once_and_finds_it_by_its_words) {
    const std::vector<Action> all = commands(some_ui());
    std::set<std::pair<std::string, std::string>> texts;
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(all[i].act) << all[i].help;
        EXPECT_TRUE(texts.insert({all[i].help, keys_of(all[i])}).second) << all[i].help;
        const std::vector<std::size_t> found = found_commands(all, all[i].help);
        EXPECT_NE(std::find(found.begin(), found.end(), i), found.end()) << all[i].help;
    }
    EXPECT_EQ(found_commands(all, "").size(), all.size());
    EXPECT_TRUE(found_commands(all, "no such thing").empty());
    EXPECT_EQ(found_commands(all, "ctrl+z").size(), 1U);
}

/// The one command whose words begin so.
class EveryRow : public testing::Test {
  protected:
    void expect(const std::string& beginning) {
        const auto count = std::count_if(all_.begin(), all_.end(), [&](const Action& row) {
            return row.help.starts_with(beginning) &&
                   (row.help.size() == beginning.size() || row.help[beginning.size()] == ',');
        });
        EXPECT_EQ(count, 1) << beginning;
        EXPECT_FALSE(found_commands(all_, beginning).empty()) << beginning;
    }
    static std::string of(std::string_view kind, std::string_view name) {
        return std::string(kind) + ": " + std::string(name);
    }
    const Ui ui_ = some_ui();
    const std::vector<Action> all_ = commands(ui_);
};

TEST_F(EveryRow, of_panels_pages_and_files_is_found) {
    for (const std::string& name : panel_names()) {
        expect(of("panel", name));
    }
    for (const LookPage& page : look_pages()) {
        expect(of("page of the look", page.name));
    }
    for (const GpuLookup* const engine : engine_lookups()) {
        expect(of("export a strip for", engine->label));
        expect(of("side A shows the strip as read by", engine->label));
        expect(of("side B shows the strip as read by", engine->label));
    }
    for (const char* const file :
         {"export the look as a LUT file", "save the picture", "save the recipe to its file",
          "save the recipe to another file", "open a look", "open again: /looks/last.cube"}) {
        expect(file);
    }
}

TEST_F(EveryRow, of_what_is_shown_is_found) {
    for (const SceneInfo& row : scenes()) {
        expect(of("scene", row.name));
    }
    ASSERT_FALSE(debug_views().empty());
    for (const DebugView& view : debug_views()) {
        expect(of("show the intermediate", view.name));
    }
    for (const SideSourceInfo& row : side_sources) {
        expect(of("side A shows", row.name));
        expect(of("side B shows", row.name));
    }
    for (const SurroundingsInfo& row : surroundings_kinds()) {
        if (row.kind != SurroundingsKind::picture) {
            expect(of("surroundings", row.name));
        }
    }
    expect("camera: door");
    expect("camera: kept 1");
}

TEST_F(EveryRow, of_how_it_is_shown_is_found) {
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        for (const Option& option : row.options()) {
            expect(of(row.label, option.name));
        }
    }
    for (const Compare& row : compares) {
        expect(of(picture_choice("compare").label, row.name));
    }
    for (const PictureView& view : picture_views()) {
        expect(of("See", view.name));
    }
    for (const Scope& scope : scopes) {
        expect(of("scope seen or not", scope.label));
    }
    for (const PostEffect* const effect : post_effects()) {
        expect(of("effect on or off", effect->label));
    }
    for (const EffectInfo& row : effects) {
        expect(of("part of the frame on or off", row.label));
    }
    for (const ZoomStep& step : zoom_steps) {
        expect(of("zoom", step.label));
    }
}

TEST_F(EveryRow, of_operators_and_encodings_is_found) {
    for (const lutlib::Op* const op : lutlib::ops()) {
        expect(of("add the operator", std::string(op->label) + " (" + std::string(op->name) + ")"));
    }
    for (const char* const place : {"picture", "look's input", "look's output"}) {
        const std::string kind = "encoding of the " + std::string(place);
        for (const lutlib::TransferCurve* const row : lutlib::transfer_curves()) {
            expect(of(kind + ", curve", row->label) + ", " + std::string(row->name));
        }
        for (const lutlib::Gamut* const row : lutlib::gamuts()) {
            expect(of(kind + ", gamut", row->label) + ", " + std::string(row->name));
        }
    }
    for (const LookAt& row : look_ats) {
        expect(of("looks stand", row.name));
    }
}

TEST(Palette, lists_first_what_begins_as_typed) {
    const std::vector<Action> all = commands(some_ui());
    const auto first = [&](const std::string& typed) {
        const std::vector<std::size_t> found = found_commands(all, typed);
        return found.empty() ? std::string() : all[found.front()].help;
    };
    EXPECT_EQ(first("Show no intermediate"), "show no intermediate, but the picture");
    EXPECT_EQ(first("undo"), "undo");
    EXPECT_TRUE(first(" scene: chart ").starts_with("scene: chart")) << first("scene: chart");
    EXPECT_TRUE(first("intermediate: normal").starts_with("show the intermediate: normal"));
}

TEST(Palette, commands_change_what_they_say) {
    Ui ui = some_ui();
    const std::vector<Action> all = commands(ui);
    const auto act = [&](const std::string& typed) {
        const std::vector<std::size_t> found = found_commands(all, typed);
        ASSERT_EQ(found.size(), 1U) << typed;
        all[found[0]].act(ui);
    };
    // What others have the words of, too.
    const auto act_on = [&](const std::string& beginning) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Action& row) {
            return row.help.starts_with(beginning);
        });
        ASSERT_NE(found, all.end()) << beginning;
        found->act(ui);
    };
    State& state = ui.history.draft();
    act("see: zebra");
    EXPECT_EQ(state.picture_view, picture_view_named("zebra"));
    act("part frame names");
    EXPECT_TRUE(state.without.has(Effect::names));
    act("part frame names");
    EXPECT_FALSE(state.without.has(Effect::names));
    act("scopes: drag the region");
    EXPECT_TRUE(ui.scopes_shown.region_drag);
    state.scopes_seen.region = {0.1F, 0.2F, 0.3F, 0.4F};
    act("scopes: count all");
    EXPECT_EQ(state.scopes_seen.region, ScopeRegion{});
    act("freeze the scopes");
    EXPECT_TRUE(ui.scopes_shown.are_frozen);
    act("panel: Cube");
    EXPECT_EQ(panel_names()[ui.panel], "Cube");
    act("page of the look: hues");
    EXPECT_EQ(look_pages()[ui.look.page].name, "Hues");
    act_on("show the intermediate: normal");
    EXPECT_EQ(ui.debug_view, "normal");
    act_on("show no intermediate");
    EXPECT_EQ(ui.debug_view, "");
    act("scene: night");
    EXPECT_EQ(ui.to_open, std::vector<std::string>{"night"});
    act("add operator (vibrance)");
    ASSERT_EQ(state.recipe.operations.size(), 1U);
    EXPECT_EQ(state.recipe.operations[0].op->name, "vibrance");
    EXPECT_EQ(look_pages()[ui.look.page].name, "Operators");
    act("look's input, curve S-Log3");
    EXPECT_EQ(state.recipe.input.curve->name, "slog3");
    EXPECT_EQ(state.recipe.input.gamut, state.recipe.input.curve->gamut);
    act("look's output, gamut rec2020");
    EXPECT_EQ(state.recipe.output_encoding().gamut->name, "rec2020");
    EXPECT_EQ(state.recipe.output_encoding().curve->name, "slog3");
    act_on("side A shows: file");
    EXPECT_EQ(state.sides[0].source, SideSource::none);
    EXPECT_EQ(ui.errors.rows().size(), 1U) << "there is no file on that side";
    act_on("side A shows the strip as read by: " + std::string(gpu_lookup_named("unity")->label));
    EXPECT_EQ(state.sides[0].source, SideSource::baked);
    EXPECT_EQ(state.sides[0].engine->name, "unity");
    act_on("export a strip for: " + std::string(gpu_lookup_named("unreal")->label));
    EXPECT_EQ(engine_lookups()[ui.export_engine]->name, "unreal");
    EXPECT_EQ(ui.file_dialog.typed, "look-unreal.png");
    ui.file_dialog = {};
    act("export look lut file");
    EXPECT_EQ(ui.file_dialog.typed, "look-export.cube");
    act("keep this camera");
    EXPECT_TRUE(ui.cameras.keep);
}

TEST(Actions, have_each_a_key_of_its_own_that_has_a_name) {
    std::set<std::string> keys;
    for (const Action& action : actions()) {
        EXPECT_FALSE(text_of(action.key).empty()) << action.help;
        EXPECT_TRUE(keys.insert(keys_of(action)).second) << keys_of(action);
    }
}

} // namespace
} // namespace preview::panels
