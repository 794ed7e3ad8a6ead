// Looks that are made for other codes than the picture's.
#include "lutlib/bake/bake.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/lut_picture.h"
#include "preview/editor/look_baker.h"
#include "preview/editor/search.h"
#include "preview/look/look_file.h"

#include <gtest/gtest.h>

#include <cmath>

namespace preview {
namespace {

// The identity, for LogC3.
constexpr const char* log_identity = "# Input encoding: logc3/rec709\n"
                                     "# Output encoding: logc3/rec709\n"
                                     "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
                                     "0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
// Half of LogC3's code, shown as it is.
constexpr const char* log_half = "# Input encoding: logc3/rec709\n# Output encoding: srgb\n"
                                 "LUT_1D_SIZE 2\n0 0 0\n0.5 0.5 0.5\n";

lutlib::io::Look look(const char* text) {
    return lutlib::io::Look::of_bytes(text, "log.cube");
}

double log_code_of_srgb(double v) {
    const double light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    return light > 0.010591 ? 0.247190 * std::log10(5.555556 * light + 0.052272) + 0.385537
                            : 5.367655 * light + 0.092809;
}

/// What is shown of a grey of the picture's codes: its table with what is converted around it.
double shown_of(const LoadedLook& look, double v) {
    lutlib::Placement around;
    if (const auto& conversion = look.data.conversion) {
        around.before = {*conversion->codes, conversion->fed};
        around.after = {conversion->gives, lutlib::srgb()};
    }
    return around.around(lutlib::Transform::of(*look.table))({v, v, v}).g;
}

TEST(PlacedLook, gets_its_own_codes_and_gives_the_pictures) {
    const LoadedLook identity = look_for(look(log_identity), {});
    const LoadedLook half = look_for(look(log_half), {});
    for (const double v : {0.0, 0.2, 0.5, 0.75, 1.0}) {
        EXPECT_NEAR(shown_of(identity, v), v, 1e-6);
        EXPECT_NEAR(shown_of(half, v), log_code_of_srgb(v) / 2, 1e-6);
    }
    ASSERT_EQ(half.told.size(), 1U);
    EXPECT_EQ(
        half.told[0],
        "srgb is converted to logc3/rec709 before the look; the look is made for scene light, "
        "and this picture's codes end at white: if they are not a display's, name "
        "--picture-encoding");
    EXPECT_EQ(half.note, "");
    EXPECT_EQ(half.skip_reason, "");
    EXPECT_EQ(identity.skip_reason, "");
}

TEST(PlacedLook, is_left_alone_where_that_is_asked_and_says_so) {
    const LoadedLook half = look_for(look(log_half), {.picture = {.convert = false}});
    EXPECT_NEAR(shown_of(half, 0.6), 0.3, 1e-6);
    ASSERT_EQ(half.told.size(), 1U);
    EXPECT_NE(half.told[0].find("left as it is"), std::string::npos);
}

TEST(PlacedLook, is_read_as_it_is_where_the_picture_is_what_it_wants) {
    const LoadedLook half = look_for(
        look(log_half), {.picture = {.encoding = *lutlib::encoding_named("logc3/rec709")}});
    EXPECT_NEAR(shown_of(half, 0.6), 0.3, 1e-6);
    EXPECT_TRUE(half.told.empty());
}

TEST(PlacedLook, is_baked_with_its_conversions_for_an_engine) {
    const LoadedLook baked = look_for(look(log_half), {.lookup = gpu_lookup_named("unreal")});
    const double v = 8.0 / 15;
    EXPECT_NEAR(baked.table->cube->at(8, 8, 8).g, log_code_of_srgb(v) / 2, 0.5 / 255 + 1e-6);
}

TEST(PlacedLook, that_is_a_picture_is_read_as_it_is_whatever_its_text_says) {
    const lutlib::Bake baked =
        lutlib::bake(lutlib::Transform{}, *lutlib::engine_named("unreal"), 16, 8);
    const auto strip = lutlib::io::Look::of_bytes(
        lutlib::io::picture_bytes(baked, {.source = "",
                                          .title = "",
                                          .interpolation = "tetrahedral",
                                          .encodings = {"logc3", "srgb"}}),
        "strip.png");
    for (const GpuLookup* lookup :
         {static_cast<const GpuLookup*>(nullptr), gpu_lookup_named("unreal")}) {
        const LoadedLook read = look_for(strip, {.lookup = lookup});
        EXPECT_NEAR(lutlib::evaluate_exact(*read.table, {0.6, 0.6, 0.6}).g, 0.6, 1e-6);
        ASSERT_FALSE(read.told.empty());
        EXPECT_NE(read.told.back().find("left as it is"), std::string::npos);
    }
}

TEST(PlacedLook, of_a_recipe_is_what_the_window_shows_too) {
    lutlib::Recipe recipe;
    recipe.input = *lutlib::encoding_named("logc3/rec709");
    recipe.output = lutlib::srgb();
    editor::Side side;
    side.source = editor::SideSource::recipe;
    const LoadedLook shown = editor::look_of(recipe, side);
    const LoadedLook left = editor::look_of(recipe, side, {.convert = false});
    // To LogC3 and from it: nothing, as near as a quick table is between its nodes. Left alone, log
    // codes are decoded that are none.
    EXPECT_NEAR(shown_of(shown, 0.5), 0.5, 2e-3);
    EXPECT_GT(std::abs(shown_of(left, 0.5) - 0.5), 0.1);
}

TEST(PlacedLook, gets_the_pictures_codes_on_every_side_of_the_window) {
    const auto logc3 = *lutlib::encoding_named("logc3/rec709");
    const lutlib::io::Look half = look(log_half);
    lutlib::Recipe recipe = half.as_recipe();
    editor::Side side;
    side.lut = half.table().lut;
    side.engine = gpu_lookup_named("unreal");
    for (const editor::SideSource source : {editor::SideSource::source, editor::SideSource::recipe,
                                            editor::SideSource::baked, editor::SideSource::file}) {
        side.source = source;
        const double v = 8.0 / 15; // a node of the engine's strip
        const auto shown = [&](const PictureCodes& picture) {
            return shown_of(editor::look_of(recipe, side, picture), v);
        };
        // Between nodes of a quick table as near as above; the strip has 8 bits.
        EXPECT_NEAR(shown({.encoding = logc3}), v / 2, 2e-3) << static_cast<int>(source);
        EXPECT_NEAR(shown({.encoding = lutlib::srgb()}), log_code_of_srgb(v) / 2, 2e-3);
        EXPECT_NEAR(shown({.encoding = lutlib::srgb(), .convert = false}), v / 2, 2e-3);
    }
}

TEST(LookRequest, is_another_one_where_the_picture_is_encoded_otherwise) {
    const editor::LookRequest one{.recipe = {}, .sides = {}};
    editor::LookRequest other = one;
    EXPECT_TRUE(editor::same(one, other));
    other.picture.encoding = *lutlib::encoding_named("logc3");
    EXPECT_FALSE(editor::same(one, other));
}

TEST(Search, finds_every_word_in_any_case) {
    EXPECT_TRUE(editor::is_found("ARRI LogC3 EI 800 (logc3)", "arri 800"));
    EXPECT_TRUE(editor::is_found("ARRI LogC3", ""));
    EXPECT_FALSE(editor::is_found("ARRI LogC3", "logc4"));
}

} // namespace
} // namespace preview
