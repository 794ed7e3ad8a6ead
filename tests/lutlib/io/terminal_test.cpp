#include "lutlib/io/terminal.h"

#include <gtest/gtest.h>

namespace lutlib::io {
namespace {

TEST(ShownText, keeps_what_people_read) {
    const std::string text = "Film \xc3\xa9t\xc3\xa9 \xe2\x80\x93 \xf0\x9f\x8e\x9e \"1\" \\n";
    EXPECT_EQ(shown_text(text), text);
}

TEST(ShownText, spells_out_what_commands_a_terminal) {
    EXPECT_EQ(shown_text("a\x1b]0;owned\a\x7f"), "a\\x1b]0;owned\\x07\\x7f");
    EXPECT_EQ(shown_text("\xc2\x9b"
                         "2J\xc2\x85"),
              "\\u009b2J\\u0085");
    EXPECT_EQ(shown_text("one\ntwo\r\tthree"), "one\\ntwo\\r\\tthree");
    EXPECT_EQ(shown_text("one\ntwo\r", '\n'), "one\ntwo\\r");
}

TEST(ShownText, spells_out_what_turns_the_direction_of_writing) {
    EXPECT_EQ(shown_text("a\xe2\x80\xae"
                         "b\xe2\x81\xa6\xd8\x9c\xe2\x80\xa8"),
              "a\\u202eb\\u2066\\u061c\\u2028");
}

TEST(ShownText, spells_out_bytes_that_are_no_characters) {
    EXPECT_EQ(shown_text("\xff\xc3"), "\\xff\\xc3");
    EXPECT_EQ(shown_text("\xc1\x81\xed\xa0\x80"), "\\xc1\\x81\\xed\\xa0\\x80");
    EXPECT_EQ(shown_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
    EXPECT_EQ(shown_text(std::string_view("\0", 1)), "\\x00");
}

} // namespace
} // namespace lutlib::io
