// What the heights of scopes stand for.
#include "preview/finish/scope_levels.h"

#include "preview/finish/scopes.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

lutlib::Encoding named(std::string_view name) {
    return *lutlib::encoding_named(name);
}

ScopeLevels levels_of(std::string_view encoding, std::string_view shown = "srgb",
                      float white = 100) {
    return {named(encoding), named(shown), white};
}

std::string texts(const ScopeLevels& levels) {
    std::string out;
    for (const LevelFigure& figure : level_figures(levels)) {
        out += figure.text + " ";
    }
    return out;
}

TEST(ScopeLevelsTest, are_told_in_the_unit_of_their_encoding) {
    EXPECT_EQ(texts({}), "0 25 50 75 100 ");
    EXPECT_EQ(texts(levels_of("slog3")), "0 25 50 75 100 ");
    EXPECT_EQ(texts(levels_of("hlg")), "0 25 50 75 100 ");
    EXPECT_EQ(texts(levels_of("pq")), "0.1 1 10 100 1000 10000 ");
    EXPECT_EQ(texts(levels_of("pq", "pq")), "0.1 1 10 100 1000 10000 ");
    EXPECT_EQ(texts(levels_of("linear")), "0 0.25 0.5 0.75 1 ");
    EXPECT_EQ(texts(levels_of("linear", "pq")), "0 25 50 75 100 "); // 10000 of 100 cd/m2
    EXPECT_EQ(texts(levels_of("linear", "pq", 200)), "0 12.5 25 37.5 50 ");
    EXPECT_EQ(level_unit(levels_of("pq")), "cd/m2");
    EXPECT_EQ(level_unit(levels_of("linear")), "of diffuse white");
    EXPECT_EQ(level_unit({}), "%");
}

// By the formula of SMPTE ST 2084.
TEST(ScopeLevelsTest, of_pq_stand_at_the_codes_of_their_luminances) {
    const std::vector<LevelFigure> figures = level_figures(levels_of("pq"));
    const double wanted[] = {0.0623, 0.1499, 0.2997, 0.5081, 0.7518, 1};
    ASSERT_EQ(figures.size(), std::size(wanted));
    for (std::size_t i = 0; i < figures.size(); ++i) {
        EXPECT_NEAR(figures[i].at, wanted[i], 5e-4) << figures[i].text;
        EXPECT_NEAR(level_value(levels_of("pq"), figures[i].at), std::stod(figures[i].text), 1e-6);
    }
}

TEST(ScopeLevelsTest, count_light_from_the_displays_white_but_in_pq_itself) {
    EXPECT_EQ(level_scale(levels_of("pq", "srgb", 203)).factor, static_cast<double>(203.0F) / 100);
    EXPECT_EQ(level_scale(levels_of("pq", "pq", 203)).factor, 1);
    EXPECT_EQ(level_scale(levels_of("pq/p3-d65", "pq", 203)).factor, 1);
    EXPECT_NEAR(level_scale(levels_of("hlg", "pq", 203)).factor, 100 / 203.0, 1e-9);
    EXPECT_EQ(level_scale(levels_of("linear", "srgb", 203)).factor, 1);
    EXPECT_FALSE(levels_of("pq", "pq").converts());
    EXPECT_TRUE(levels_of("pq/p3-d65", "pq").converts());
    EXPECT_FALSE(ScopeLevels{}.converts());
}

TEST(ScopeLevelsTest, say_what_they_are_and_the_white_where_it_counts) {
    EXPECT_EQ(levels_text({}), "levels are the codes as they are shown, in per cent");
    EXPECT_EQ(
        levels_text(levels_of("pq", "srgb", 203)),
        "levels are pq of the shown srgb, the display's white at 203 cd/m2; figures are cd/m2");
    EXPECT_EQ(levels_text(levels_of("pq", "pq")),
              "levels are pq, as it is shown; figures are cd/m2");
    EXPECT_EQ(levels_text(levels_of("hlg")),
              "levels are hlg of the shown srgb; figures are per cent");
}

TEST(ScopeLevelsTest, read_the_codes_of_the_side_that_is_measured) {
    const std::array sides{named("pq"), lutlib::srgb()};
    for (const Compare& compare : compares) {
        if (compare.shows_a) {
            EXPECT_EQ(shown_codes(scope_sides[1], compare, sides), named("pq")) << compare.name;
        }
        if (compare.shows_b) {
            EXPECT_EQ(shown_codes(scope_sides[2], compare, sides), lutlib::srgb()) << compare.name;
        }
        const auto all = shown_codes(scope_side_shown, compare, sides);
        EXPECT_EQ(all.has_value(), !(compare.shows_a && compare.shows_b)) << compare.name;
        EXPECT_EQ(shown_codes(scope_side_shown, compare, {named("pq"), named("pq")}), named("pq"));
    }
}

} // namespace
} // namespace preview
