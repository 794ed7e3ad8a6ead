#include "preview/look/recipe_table.h"

#include <gtest/gtest.h>

#include <memory>

namespace preview {
namespace {

// The wrong node lies on an edge of a cell of the quick table, which goes by it.
TEST(RecipeTable, sees_a_single_node_of_the_base_that_the_quick_table_lacks) {
    auto base = std::make_shared<lutlib::Lut>();
    base->cube = lutlib::identity_cube(65);
    base->cube->at(31, 20, 40).g += 0.3F;
    lutlib::Recipe recipe;
    recipe.base_lut = base;
    const auto table = measured_table(recipe);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->nodes, 65);
    EXPECT_LT(table->max_error, 0.01);
}

TEST(RecipeTable, gives_nothing_once_it_is_told_to_stop) {
    auto base = std::make_shared<lutlib::Lut>();
    base->cube = lutlib::identity_cube(17);
    lutlib::Recipe recipe;
    recipe.base_lut = base;
    int asked = 0;
    EXPECT_FALSE(measured_table(recipe, [&] { return ++asked > 3; }));
}

} // namespace
} // namespace preview
