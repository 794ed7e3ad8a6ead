// What the palette offers, and what it finds.
#include "preview/panels/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace preview::panels {
namespace {

TEST(Palette, offers_every_command_once_and_finds_it_by_its_words) {
    const std::vector<Action> all = commands();
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

TEST(Palette, names_every_panel_every_option_and_every_switch) {
    const std::vector<Action> all = commands();
    std::size_t rows = actions().size() + panel_names().size() + effects.size() + scopes.size();
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        rows += row.options().size();
    }
    EXPECT_GE(all.size(), rows);
    for (const PictureView& view : picture_views()) {
        EXPECT_FALSE(found_commands(all, "see: " + std::string(view.name)).empty()) << view.name;
    }
}

TEST(Palette, commands_change_what_they_say) {
    Ui ui(initial_state());
    const std::vector<Action> all = commands();
    const auto act = [&](const std::string& typed) {
        const std::vector<std::size_t> found = found_commands(all, typed);
        ASSERT_EQ(found.size(), 1U) << typed;
        all[found[0]].act(ui);
    };
    act("see: zebra");
    EXPECT_EQ(ui.history.draft().picture_view, picture_view_named("zebra"));
    act("part frame names");
    EXPECT_TRUE(ui.history.draft().without.has(Effect::names));
    act("part frame names");
    EXPECT_FALSE(ui.history.draft().without.has(Effect::names));
    act("scopes: drag the region");
    EXPECT_TRUE(ui.region_drag);
    ui.history.draft().scopes_seen.region = {0.1F, 0.2F, 0.3F, 0.4F};
    act("scopes: count all");
    EXPECT_EQ(ui.history.draft().scopes_seen.region, ScopeRegion{});
    act("freeze the scopes");
    EXPECT_TRUE(ui.scopes_frozen);
    act("panel: Cube");
    EXPECT_EQ(panel_names()[ui.panel], "Cube");
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
