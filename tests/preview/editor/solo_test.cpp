#include "preview/editor/solo.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

State three_operators() {
    State state = initial_state();
    for (const char* name : {"exposure", "contrast", "saturation"}) {
        add_operation(state.recipe, *lutlib::op_named(name));
    }
    return state;
}

std::string_view name_at(const State& state, std::size_t at) {
    return state.recipe.operations[at].op->name;
}

TEST(Solo, shows_one_operator_even_where_it_is_bypassed_and_leaves_the_recipe) {
    State state = three_operators();
    EXPECT_TRUE(same(shown_recipe(state), state.recipe));
    toggle_bypass(state, 1);
    EXPECT_FALSE(state.recipe.operations[1].enabled);
    toggle_solo(state, 1);
    const lutlib::Recipe shown = shown_recipe(state);
    ASSERT_EQ(shown.operations.size(), 1U);
    EXPECT_EQ(shown.operations[0].op->name, "contrast");
    EXPECT_TRUE(shown.operations[0].enabled);
    EXPECT_EQ(state.recipe.operations.size(), 3U);
    toggle_solo(state, 2);
    EXPECT_EQ(shown_recipe(state).operations[0].op->name, "saturation");
    toggle_solo(state, 2);
    EXPECT_TRUE(same(shown_recipe(state), state.recipe));
    toggle_bypass(state, 1);
    EXPECT_TRUE(state.recipe.operations[1].enabled);
}

TEST(Solo, follows_its_operator_through_every_move_and_removal) {
    for (std::size_t solo = 0; solo < 3; ++solo) {
        for (std::size_t at = 0; at < 3; ++at) {
            for (std::size_t to = 0; to < 3; ++to) {
                State state = three_operators();
                toggle_solo(state, solo);
                const std::string_view name = name_at(state, solo);
                move_operation(state, at, to);
                ASSERT_TRUE(state.solo);
                EXPECT_EQ(name_at(state, *state.solo), name) << at << " to " << to;
            }
            State state = three_operators();
            toggle_solo(state, solo);
            const std::string_view name = name_at(state, solo);
            remove_operation(state, at);
            ASSERT_EQ(state.solo.has_value(), at != solo);
            if (state.solo) {
                EXPECT_EQ(name_at(state, *state.solo), name);
            }
        }
    }
}

TEST(Solo, of_an_operator_that_is_no_longer_there_shows_all) {
    State state = three_operators();
    toggle_solo(state, 2);
    state.recipe.operations.resize(1);
    EXPECT_TRUE(same(shown_recipe(state), state.recipe));
}

TEST(Solo, is_undone) {
    History history(three_operators());
    toggle_solo(history.draft(), 1);
    EXPECT_TRUE(history.settle());
    EXPECT_TRUE(history.undo());
    EXPECT_FALSE(history.draft().solo);
}

} // namespace
} // namespace preview::editor
