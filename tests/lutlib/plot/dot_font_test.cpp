#include "lutlib/plot/dot_font.h"
#include "lutlib/plot/raster.h"

#include <gtest/gtest.h>

#include <set>

namespace plot {
namespace {

constexpr Rgb8 ground{0, 0, 0}, ink{255, 128, 0};

std::string dots_of(char glyph) {
    std::string out;
    for (int y = 0; y < glyph_height; ++y) {
        for (int x = 0; x < glyph_width; ++x) {
            out += has_dot(glyph, x, y) ? '#' : '.';
        }
    }
    return out;
}

std::size_t inked(const Raster& picture) {
    std::size_t out = 0;
    for (const Rgb8& pixel : picture.pixels()) {
        out += pixel == ink;
    }
    return out;
}

TEST(DotFont, has_a_glyph_of_its_own_for_every_character_of_ascii) {
    std::set<std::string> all;
    for (char c = ' '; c <= '~'; ++c) {
        all.insert(dots_of(c));
        EXPECT_EQ(dots_of(c).find('#') == std::string::npos, c == ' ') << c;
    }
    all.insert(dots_of(unknown_glyph));
    EXPECT_EQ(all.size(), 96U);
}

// Capitals that are the same from both sides have to be so in the table, and stand on the line.
TEST(DotFont, draws_symmetric_capitals_symmetric_and_on_the_line) {
    for (const char c : std::string("AHIMOTUVWXY")) {
        for (int y = 0; y < glyph_height; ++y) {
            for (int x = 0; x < glyph_width; ++x) {
                EXPECT_EQ(has_dot(c, x, y), has_dot(c, glyph_width - 1 - x, y)) << c;
            }
        }
        EXPECT_EQ(dots_of(c).find_last_of('#') / glyph_width, 6U) << c;
    }
    EXPECT_EQ(dots_of('T'), "#####..#....#....#....#....#....#............");
}

TEST(DotFont, lets_only_what_hangs_below_the_line_hang_below_it) {
    const std::string hanging = "gjpqy,;";
    for (char c = '!'; c <= '~'; ++c) {
        const bool hangs = dots_of(c).find('#', glyph_width * 7) != std::string::npos;
        EXPECT_EQ(hangs, hanging.find(c) != std::string::npos) << c;
    }
}

TEST(DotFont, takes_one_glyph_for_each_character_of_utf8) {
    const std::string box(1, unknown_glyph);
    EXPECT_EQ(glyphs_of("a b~"), "a b~");
    EXPECT_EQ(glyphs_of("\xc3\xa9t\xc3\xa9"), box + "t" + box);
    EXPECT_EQ(glyphs_of("\xe2\x82\xac\xf0\x9f\x8e\xa8"), box + box);
    EXPECT_EQ(glyphs_of("a\nb\x7f"), "a" + box + "b" + box);
    EXPECT_EQ(glyphs_of("\x80\xff"), box + box);
}

TEST(DotFont, cuts_a_long_text_in_the_middle_and_keeps_both_ends) {
    EXPECT_EQ(cut_in_the_middle("warm_teal", 9), "warm_teal");
    EXPECT_EQ(cut_in_the_middle("warm_teal", 8), "war...al");
    EXPECT_EQ(cut_in_the_middle("0123456789", 7), "01...89");
    EXPECT_EQ(cut_in_the_middle("0123456789", 4), "0...");
    EXPECT_EQ(cut_in_the_middle("0123456789", 2), "..");
    EXPECT_EQ(cut_in_the_middle("0123456789", 0), "");
    EXPECT_EQ(cut_in_the_middle("", 0), "");
}

TEST(Raster, writes_every_dot_as_a_square_and_nothing_between) {
    Raster small(12, 9, ground), large(36, 27, ground);
    small.write("Rg", 0, 0, 1, ink);
    large.write("Rg", 0, 0, 3, ink);
    EXPECT_GT(inked(small), 20U);
    for (int y = 0; y < large.height(); ++y) {
        for (int x = 0; x < large.width(); ++x) {
            EXPECT_EQ(large.at(x, y), small.at(x / 3, y / 3));
        }
    }
    EXPECT_TRUE(small.at(0, 0) == ink && small.at(5, 0) == ground);
}

TEST(Raster, draws_nothing_outside_of_itself) {
    Raster picture(8, 8, ground);
    picture.write("WWW", -4, -3, 2, ink);
    picture.write("W", 6, 6, 4, ink);
    EXPECT_GT(inked(picture), 0U);
    Raster other(3, 3, ink), place(8, 8, ground);
    place.place(other, -1, 6);
    EXPECT_EQ(inked(place), 4U);
    place.fill(7, 0, 100, 1, ink);
    EXPECT_EQ(inked(place), 5U);
    place.place(other, 100, 100);
    place.fill(-5, -5, 3, 3, ink);
    EXPECT_EQ(inked(place), 5U);
}

} // namespace
} // namespace plot
