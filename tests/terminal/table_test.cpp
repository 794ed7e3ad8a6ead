#include "terminal/table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace terminal {
namespace {

std::size_t longest_line(const std::string& text) {
    std::istringstream lines(text);
    std::size_t out = 0;
    for (std::string line; std::getline(lines, line);) {
        out = std::max(out, line.size());
    }
    return out;
}

std::string joined_words(const std::string& text) {
    std::istringstream in(text);
    std::string out;
    for (std::string word; in >> word;) {
        out += word + " ";
    }
    return out;
}

Table table() {
    Table out;
    out.heading("curves");
    out.row({"logc3", "ARRI LogC3 EI 800, arri-wide-gamut-3",
             "ARRI, ALEXA Log C Curve: Usage in VFX, 2017"});
    out.row({"srgb", "sRGB, rec709", "IEC 61966-2-1"});
    return out;
}

TEST(Table, is_columns_under_each_other_without_a_bound) {
    EXPECT_EQ(table().text(),
              "curves\n"
              "  logc3  ARRI LogC3 EI 800, arri-wide-gamut-3  ARRI, ALEXA Log C Curve: Usage in "
              "VFX, 2017\n"
              "  srgb   sRGB, rec709                          IEC 61966-2-1\n");
    Table pair;
    pair.row({"a", "", ""});
    pair.row({"", "b"});
    EXPECT_EQ(pair.text(), "a\n   b\n");
}

TEST(Table, wraps_its_last_column_while_that_has_room_and_else_puts_cells_below) {
    EXPECT_EQ(table().text(76),
              "curves\n"
              "  logc3  ARRI LogC3 EI 800, arri-wide-gamut-3  ARRI, ALEXA Log C Curve:\n"
              "                                               Usage in VFX, 2017\n"
              "  srgb   sRGB, rec709                          IEC 61966-2-1\n");
    EXPECT_EQ(table().text(50), "curves\n"
                                "  logc3  ARRI LogC3 EI 800, arri-wide-gamut-3\n"
                                "         ARRI, ALEXA Log C Curve: Usage in VFX,\n"
                                "         2017\n"
                                "  srgb   sRGB, rec709\n"
                                "         IEC 61966-2-1\n");
}

TEST(Table, fits_every_width_and_loses_no_word) {
    const std::string all = joined_words(table().text());
    for (std::size_t columns = 24; columns < 120; ++columns) {
        const std::string text = table().text(columns);
        EXPECT_LE(longest_line(text), columns) << text;
        EXPECT_EQ(joined_words(text), all);
    }
    // One that cannot: a word too long by itself.
    EXPECT_GT(longest_line(table().text(10)), 10U);
}

TEST(Table, counts_characters_and_spells_out_what_would_command_the_terminal) {
    Table out;
    out.row({"Gr\u00fcn", "a"});
    out.row({"Blau", "\x1b[2Jb"});
    EXPECT_EQ(out.text(), "Gr\u00fcn  a\nBlau  \\x1b[2Jb\n");
}

TEST(Table, has_colors_only_where_the_style_has_them) {
    EXPECT_EQ(table().text().find('\x1b'), std::string::npos);
    const std::string text = table().text(0, Style(true));
    EXPECT_NE(text.find("  \x1b[1mlogc3\x1b[0m  ARRI"), std::string::npos) << text;
    EXPECT_NE(text.find("  \x1b[1msrgb\x1b[0m   sRGB"), std::string::npos) << text;
}

TEST(Help, is_wrapped_under_its_descriptions_and_leaves_examples_alone) {
    const std::string help = "Does what it is asked for, and then some more of it.\n"
                             "  --size INT                  How large the output is, in pixels "
                             "of both sides\n"
                             "Examples:\n"
                             "program --size 100 --and-many-words that --stand in --one line.png\n";
    EXPECT_EQ(wrapped_help(help, 50),
              "Does what it is asked for, and then some more of\n"
              "it.\n"
              "  --size INT                  How large the output\n"
              "                              is, in pixels of\n"
              "                              both sides\n"
              "Examples:\n"
              "program --size 100 --and-many-words that --stand in --one line.png\n");
    EXPECT_EQ(wrapped_help(help, 0), help);
}

} // namespace
} // namespace terminal
