// ASC CDL files and the look's operator, as the window opens and saves them.
#include "preview/editor/corrections.h"

#include "lutlib/error.h"
#include "lutlib/io/correction_files.h"
#include "lutlib/io/file.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

TEST(Corrections, go_into_the_looks_first_cdl_whose_clamp_and_opacity_stay) {
    State state = initial_state();
    EXPECT_EQ(put_correction(state, {.id = "a", .slope = {0.5, 1, 1}}), "");
    ASSERT_EQ(cdl_of(state.recipe), 0U);
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    add_operation(state.recipe, *lutlib::op_named("cdl"));
    state.recipe.operations[0].values.back() = 1.0;
    state.recipe.operations[0].opacity = 0.5;
    put_correction(state, {.id = "b", .saturation = 0.25});
    ASSERT_EQ(state.recipe.operations.size(), 3U);
    const lutlib::Operation& put = state.recipe.operations[0];
    EXPECT_EQ(std::get<lutlib::RgbD>(put.values[0]), (lutlib::RgbD{1, 1, 1}));
    EXPECT_EQ(std::get<double>(put.values[3]), 0.25);
    EXPECT_EQ(std::get<double>(put.values[4]), 1);
    EXPECT_EQ(put.opacity, 0.5);
    EXPECT_TRUE(is_identity(state.recipe.operations[2]));
}

TEST(Corrections, tell_what_does_not_hold_and_what_the_standard_would_clamp) {
    State state = initial_state();
    const std::string told = put_correction(state, {.offset = {12, 0, 0}, .power = {1, 0, 1}});
    EXPECT_NE(told.find("offset of red is 12"), std::string::npos) << told;
    EXPECT_NE(told.find("power of green is 0"), std::string::npos) << told;
    EXPECT_NE(told.find("the standard clamps to 0..1"), std::string::npos) << told;
    state.recipe.operations[0].values.back() = 1.0;
    EXPECT_EQ(put_correction(state, {.saturation = 3}), "") << "it clamps already";
}

TEST(Corrections, are_saved_beside_those_that_are_there) {
    const lutlib::ScratchFolder scratch;
    const std::string path = scratch.file("shots.ccc");
    State state = initial_state();
    EXPECT_THROW(prepare_correction(state, "a", path), lutlib::Error) << "there is no CDL";
    put_correction(state, {.slope = {0.5, 1, 1}});
    const PreparedExport first = prepare_correction(state, "a", path);
    EXPECT_FALSE(first.loses) << first.report;
    write(first);
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    state.recipe.operations[1].values[0] = 1.0;
    state.recipe.title = "Night";
    const PreparedExport second = prepare_correction(state, "b", path);
    EXPECT_TRUE(second.loses);
    EXPECT_NE(second.report.find("other operators"), std::string::npos) << second.report;
    EXPECT_NE(second.report.find("with the 1 that stay"), std::string::npos) << second.report;
    write(second);
    const auto read = lutlib::io::read_corrections(path);
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0], (lutlib::ColorCorrection{.id = "a", .slope = {0.5, 1, 1}}));
    EXPECT_EQ(read[1],
              (lutlib::ColorCorrection{.id = "b", .description = "Night", .slope = {0.5, 1, 1}}));
    EXPECT_THROW(prepare_correction(state, "a", scratch.file("x.cube")), lutlib::Error);
}

} // namespace
} // namespace preview::editor
