// The rows of the settings: each has a member of its own, a default within its range, and shows.
#include "preview/finish/picture_settings.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

TEST(PictureSettings, have_a_row_for_every_number_that_changes_it_alone) {
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        PictureSettings changed;
        row.of(changed) = static_cast<float>(row.max);
        EXPECT_FALSE(changed == PictureSettings{}) << row.flag;
        for (const NumberRow<PictureSettings>& other : picture_numbers()) {
            if (&other != &row) {
                EXPECT_EQ(other.value(changed), other.value({})) << row.flag << ' ' << other.flag;
            }
        }
        EXPECT_EQ(&picture_number(row.flag), &row);
    }
}

TEST(PictureSettings, have_defaults_within_their_ranges) {
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        const double value = static_cast<double>(row.value({}));
        EXPECT_GE(value, row.min) << row.flag;
        EXPECT_LE(value, row.max) << row.flag;
        EXPECT_FALSE(row.help.empty()) << row.flag;
    }
}

TEST(PictureSettings, choose_every_row_of_every_table) {
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        const std::vector<Option> options = row.options();
        EXPECT_GT(options.size(), 1U);
        for (std::size_t i = 0; i < options.size(); ++i) {
            PictureSettings settings;
            row.choose(settings, i);
            EXPECT_EQ(row.chosen(settings), i) << row.flag;
        }
        EXPECT_EQ(&picture_choice(row.flag), &row);
    }
}

TEST(PictureSettings, are_told_with_their_units) {
    PictureSettings settings;
    settings.exposure = -1.5F;
    settings.tonemap = tonemap_named("none");
    const std::string text = settings_text(settings);
    EXPECT_NE(text.find("setting   exposure -1.5 stops\n"), std::string::npos) << text;
    EXPECT_NE(text.find("setting   tonemap none\n"), std::string::npos) << text;
}

TEST(PictureSettings, that_stand_for_a_methods_own_say_so_with_its_value) {
    PictureSettings settings;
    settings.bloom = bloom_named("glare");
    const NumberRow<PictureSettings>& strength = picture_number("bloom-strength");
    EXPECT_TRUE(strength.is_own(settings));
    EXPECT_EQ(strength.value(settings), settings.bloom->strength);
    const std::string text = settings_text(settings);
    EXPECT_NE(text.find("setting   bloom-strength " +
                        number_text(settings.bloom->strength, "the method's own") + "\n"),
              std::string::npos)
        << text;
    settings.bloom_settings.strength = 0.5F;
    EXPECT_FALSE(strength.is_own(settings));
    EXPECT_NE(settings_text(settings).find("setting   bloom-strength 0.5\n"), std::string::npos);
}

TEST(HeatMap, ends_at_the_99th_percentile_up_to_what_its_scale_can_show) {
    EXPECT_EQ(heat_scale_for({.p99 = 0}), 4);
    EXPECT_EQ(heat_scale_for({.p99 = 4.1}), 8);
    EXPECT_EQ(heat_scale_for({.p99 = 500}), 96);
}

} // namespace
} // namespace preview
