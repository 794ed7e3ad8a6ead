// Where looks stand, what is converted around them there, and the curves that shaders read for it.
#include "lutlib/color/display_curve.h"
#include "lutlib/error.h"
#include "preview/look/look_standing.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <cmath>

namespace preview {
namespace {

using lutlib::LookEncodings;

lutlib::Encoding named(const char* name) {
    return *lutlib::encoding_named(name);
}

LookEncodings from_to(const char* input, const char* output) {
    return {named(input), named(output)};
}

class EveryCurveInPieces : public testing::TestWithParam<const lutlib::TransferCurve*> {};

TEST_P(EveryCurveInPieces, encodes_light_within_a_millionth_of_a_code_and_nearly_at_its_joints) {
    const lutlib::TransferCurve& curve = *GetParam();
    const CubicCurve pieces(curve);
    int at_joints = 0;
    for (int i = -24 * 37; i < 16 * 37; ++i) {
        const auto light = static_cast<float>(std::exp2(i / 37.0));
        const double wanted = curve.encode(static_cast<double>(light));
        const double error =
            std::abs(static_cast<double>(pieces.encode(light)) - wanted) / std::max(1.0, wanted);
        EXPECT_LE(error, 6e-5) << light;
        at_joints += error > 1e-6 ? 1 : 0;
    }
    EXPECT_LE(at_joints, 3);
    EXPECT_NEAR(static_cast<double>(pieces.encode(0)), curve.encode(0), 1e-6);
    EXPECT_NEAR(static_cast<double>(pieces.encode(-0.001F)), curve.encode(-0.001), 1e-5);
}

TEST_P(EveryCurveInPieces, decodes_codes_within_a_hundred_thousandth_and_nearly_at_its_joints) {
    const lutlib::TransferCurve& curve = *GetParam();
    const CubicCurve pieces(curve);
    int at_joints = 0;
    for (int i = 0; i <= 1777; ++i) {
        const float code = static_cast<float>(i) / 1777;
        const double wanted = curve.decode(static_cast<double>(code));
        if (wanted < 0) {
            continue;
        }
        const double error = std::abs(static_cast<double>(pieces.decode(code)) - wanted);
        EXPECT_LE(error, 1.2e-4 * std::max(1.0, wanted)) << code;
        at_joints += error > std::max(1e-6, 1e-5 * wanted) ? 1 : 0;
    }
    EXPECT_LE(at_joints, 6);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryCurveInPieces,
                         testing::ValuesIn(lutlib::transfer_curves().begin(),
                                           lutlib::transfer_curves().end()),
                         [](const auto& row) { return support::test_name(row.param->name); });

TEST(LookStanding, of_log_and_linear_looks_is_before_the_tone_map_where_there_is_light) {
    const PictureCodes light{.has_light = true};
    for (const lutlib::TransferCurve* curve : lutlib::transfer_curves()) {
        const lutlib::Encoding input{curve, curve->gamut};
        const LookStanding got = standing_of({input, lutlib::srgb()}, nullptr, light);
        EXPECT_EQ(got.is_before(), !is_display_curve(*curve)) << curve->name;
        EXPECT_FALSE(standing_of({input, lutlib::srgb()}, nullptr, {}).is_before()) << curve->name;
    }
}

TEST(LookStanding, a_display_picture_out_of_scene_light_has_no_tone_map_after_it) {
    const PictureCodes light{.has_light = true};
    const LookStanding picture = standing_of(from_to("logc3", "srgb"), nullptr, light);
    EXPECT_TRUE(picture.conversion->is_picture);
    EXPECT_FALSE(picture.place.applied().converts());
    EXPECT_NE(picture.sentence.find("no tone map follows"), std::string::npos);
    const LookStanding graded = standing_of(from_to("logc3", "logc3"), nullptr, light);
    EXPECT_FALSE(graded.conversion->is_picture);
}

TEST(LookStanding, follows_what_is_asked_and_says_what_a_look_cannot_get_there) {
    PictureCodes asked{.has_light = true, .at = &look_at_after};
    const LookStanding late = standing_of(from_to("logc3", "srgb"), nullptr, asked);
    EXPECT_FALSE(late.is_before());
    EXPECT_TRUE(late.is_told);
    EXPECT_NE(late.sentence.find("what the tone map makes of it"), std::string::npos);
    asked.at = &look_at_before;
    const LookStanding early = standing_of(from_to("srgb", "srgb"), nullptr, asked);
    ASSERT_TRUE(early.is_before());
    EXPECT_FALSE(early.conversion->is_picture);
    EXPECT_NE(early.sentence.find("light above white is beyond its table"), std::string::npos);
    const LookStanding of_codes = standing_of(from_to("logc3", "srgb"), nullptr, {});
    EXPECT_NE(of_codes.sentence.find("name --picture-encoding"), std::string::npos);
    EXPECT_TRUE(of_codes.is_told);
}

TEST(LookStanding, of_an_engine_that_grades_scene_light_is_before_the_tone_map) {
    const GpuLookup* const o3de = gpu_lookup_named("o3de");
    const LookStanding got = standing_of(from_to("srgb", "srgb"), o3de, {.has_light = true});
    ASSERT_TRUE(got.is_before());
    EXPECT_EQ(got.conversion->fed, named("o3de-log2"));
    EXPECT_EQ(got.conversion->gives, named("o3de-log2"));
    EXPECT_TRUE(got.place.applied().before && got.place.applied().after);
    EXPECT_THROW(standing_of(from_to("srgb", "srgb"), o3de, {}), lutlib::UsageError);
    EXPECT_THROW(
        standing_of(from_to("srgb", "srgb"), o3de, {.has_light = true, .at = &look_at_after}),
        lutlib::UsageError);
    EXPECT_THROW(standing_of(from_to("srgb", "srgb"), gpu_lookup_named("unreal"),
                             {.has_light = true, .at = &look_at_before}),
                 lutlib::UsageError);
}

TEST(LookStanding, behind_the_tone_map_leaves_what_must_be_converted_to_the_shader) {
    PictureCodes picture{.encoding = named("logc3")};
    const LookStanding got = standing_of(from_to("srgb", "rec709"), nullptr, picture);
    ASSERT_TRUE(got.conversion);
    EXPECT_EQ(*got.conversion,
              (LookConversion{named("logc3"), named("srgb"), named("rec709"), true}));
    EXPECT_FALSE(got.place.applied().converts());
    EXPECT_NE(got.sentence.find("logc3 is converted to srgb"), std::string::npos) << got.sentence;
    const LookStanding unknown = standing_of({}, nullptr, picture);
    EXPECT_FALSE(unknown.conversion);
    picture.convert = false;
    EXPECT_FALSE(standing_of(from_to("srgb", "rec709"), nullptr, picture).conversion);
}

TEST(LookStanding, of_an_engine_behind_the_tone_map_leaves_it_to_the_picture_that_it_reads) {
    const LookStanding got =
        standing_of(from_to("logc3", "srgb"), gpu_lookup_named("unreal"), {.at = &look_at_after});
    EXPECT_FALSE(got.conversion);
    EXPECT_TRUE(got.place.applied().converts());
}

TEST(PlaceBits, are_none_where_a_look_behind_the_tone_map_needs_no_conversion) {
    EXPECT_EQ(place_bits({lutlib::srgb(), lutlib::srgb(), lutlib::srgb(), true}), 0U);
    EXPECT_EQ(place_bits({lutlib::srgb(), named("linear"), lutlib::srgb(), true}),
              PlaceBits::opens | PlaceBits::is_picture);
    EXPECT_EQ(place_bits({named("pq"), named("pq"), named("pq"), true}),
              PlaceBits::decodes | PlaceBits::is_picture);
    EXPECT_EQ(place_bits({{}, named("linear"), named("linear"), false}), PlaceBits::before);
}

TEST(ConversionRows, are_as_many_as_shaders_count_on) {
    EXPECT_EQ(conversion_rows({named("pq"), named("logc3"), lutlib::srgb(), true}).size(),
              conversion_row_count);
}

} // namespace
} // namespace preview
