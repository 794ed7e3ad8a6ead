// Versions of the look: stored, brought back, shown beside the look as it is.
#include "preview/editor/look_baker.h"
#include "preview/editor/versions.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

State edited(std::string_view op) {
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named(op));
    return state;
}

TEST(Versions, come_back_as_they_were_stored) {
    State state = edited("saturation");
    store_version(state, 3);
    const lutlib::Recipe stored = state.recipe;
    add_operation(state.recipe, *lutlib::op_named("contrast"));
    EXPECT_FALSE(same(state.recipe, stored));
    EXPECT_FALSE(recall_version(state, 2)) << "nothing was stored there";
    EXPECT_FALSE(same(state.recipe, stored));
    EXPECT_TRUE(recall_version(state, 3));
    EXPECT_TRUE(same(state.recipe, stored));
    EXPECT_TRUE(is_unsaved(state));
}

TEST(Versions, are_steps_that_undo_takes_back) {
    History history(edited("saturation"));
    store_version(history.draft(), 0);
    EXPECT_TRUE(history.settle());
    add_operation(history.draft().recipe, *lutlib::op_named("contrast"));
    history.settle();
    recall_version(history.draft(), 0);
    EXPECT_TRUE(history.settle());
    EXPECT_EQ(history.draft().recipe.operations.size(), 1U);
    history.undo();
    EXPECT_EQ(history.draft().recipe.operations.size(), 2U);
    history.undo();
    history.undo();
    EXPECT_EQ(history.draft().versions[0], nullptr);
}

TEST(Versions, are_shown_on_a_side_as_their_recipes_are) {
    State state = edited("saturation");
    std::get<double>(state.recipe.operations[0].values[0]) = 0;
    Side recipe_side;
    recipe_side.source = SideSource::recipe;
    const LoadedLook expected = look_of(state.recipe, recipe_side);
    store_version(state, 8);
    state.recipe.operations.clear();
    state.compare = &compare_b;
    EXPECT_TRUE(show_version(state, 8, 0));
    EXPECT_EQ(state.compare, &compare_split) << "side A is not seen else";
    const LoadedLook shown = look_of(state.recipe, state.sides[0]);
    ASSERT_TRUE(shown.table && expected.table);
    EXPECT_EQ(shown.table->cube->nodes, expected.table->cube->nodes);
    // What is stored there later does not change what is shown.
    store_version(state, 8);
    EXPECT_EQ(look_of(state.recipe, state.sides[0]).table->cube->nodes,
              expected.table->cube->nodes);
    EXPECT_EQ(title_of(state.sides[0]), "version 9");
}

TEST(Versions, are_called_by_title_or_by_what_they_do) {
    State state = edited("saturation");
    EXPECT_EQ(name_of({state.recipe, {}, {}}), std::string(lutlib::op_named("saturation")->label));
    state.recipe.operations[0].enabled = false;
    EXPECT_EQ(name_of({state.recipe, {}, {}}), "no operators");
    state.recipe.title = "Warm";
    EXPECT_EQ(name_of({state.recipe, {}, {}}), "Warm");
}

} // namespace
} // namespace preview::editor
