// The looks that the window shows: baked beside its frames, as finely as can be seen.
#include "preview/editor/look_baker.h"

#include "lutlib/metrics/compare.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/transform.h"
#include "preview/look/recipe_table.h"

#include <gtest/gtest.h>

#include <chrono>

namespace preview::editor {
namespace {

TEST(Side, is_baked_for_every_engine_and_every_source) {
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("saturation"));
    state.recipe.operations[0].values[0] = 0.25;
    for (const SideSourceInfo& info : side_sources) {
        for (const GpuLookup* engine : engine_lookups()) {
            Side side;
            side.source = info.source;
            side.engine = engine;
            const LoadedLook look = look_of(state.recipe, side, {.has_light = true});
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

TEST(RecipeTable, is_measured_over_the_inputs_that_it_takes) {
    lutlib::Recipe recipe;
    add_operation(recipe, *lutlib::op_named("exposure"));
    recipe.operations[0].values[0] = 1.0;
    recipe.bake.domain = lutlib::Domain{{0.5F, 0.5F, 0.5F}, {2, 2, 2}};
    const RecipeTable table = *measured_table(recipe);
    const std::vector<lutlib::Rgb> inputs = lutlib::over_domain(
        lutlib::sample_colors(2, {.random = 10'000, .lattice = false}), table.lut.domain());
    const double largest = compare(lutlib::Transform::of(recipe), lutlib::Transform::of(table.lut),
                                   inputs, lutlib::srgb())
                               .delta_e_2000.max;
    EXPECT_GT(largest, 0);
    EXPECT_GE(table.max_error, 0.999 * largest);
    EXPECT_LE(table.max_error, 1.5 * largest); // of colours that need not be the worst
}

TEST(RecipeTable, stops_when_it_is_told) {
    lutlib::Recipe recipe;
    add_operation(recipe, *lutlib::op_named("exposure"));
    int asked = 0;
    EXPECT_FALSE(measured_table(recipe, [&] { return ++asked == 3; }));
    EXPECT_EQ(asked, 3);
}

} // namespace
} // namespace preview::editor
