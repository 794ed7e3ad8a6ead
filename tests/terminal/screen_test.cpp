// What a program prints on a terminal of a given width, and through a pipe.
#include "terminal/style.h"

#include <gtest/gtest.h>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Words = std::vector<std::string>;

/// What lutconv prints on a terminal of that many columns, with these variables ("NAME=VALUE").
std::string on_terminal(int columns, const Words& arguments, const Words& variables = {}) {
    winsize size{};
    size.ws_col = static_cast<unsigned short>(columns);
    size.ws_row = 40;
    int screen = -1;
    const pid_t child = forkpty(&screen, nullptr, nullptr, &size);
    if (child == 0) {
        ::unsetenv("COLUMNS");
        ::unsetenv("NO_COLOR");
        ::setenv("TERM", "xterm", 1);
        for (const std::string& variable : variables) {
            const std::size_t sign = variable.find('=');
            ::setenv(variable.substr(0, sign).c_str(), variable.substr(sign + 1).c_str(), 1);
        }
        std::vector<char*> argv{const_cast<char*>(LUTCONV)};
        for (const std::string& word : arguments) {
            argv.push_back(const_cast<char*>(word.c_str()));
        }
        argv.push_back(nullptr);
        ::execv(LUTCONV, argv.data());
        ::_exit(127);
    }
    std::string out;
    char buffer[4096];
    for (ssize_t count = 0; (count = ::read(screen, buffer, sizeof buffer)) > 0;) {
        out.append(buffer, static_cast<std::size_t>(count));
    }
    ::close(screen);
    int status = 0;
    ::waitpid(child, &status, 0);
    return out;
}

bool has_color(const std::string& text) {
    return text.find("\x1b[") != std::string::npos;
}

std::size_t longest_line(const std::string& text) {
    std::istringstream lines(text);
    std::size_t longest = 0;
    for (std::string line; std::getline(lines, line);) {
        std::size_t width = 0;
        bool is_mark = false;
        for (const char c : line) {
            is_mark = is_mark || c == '\x1b';
            // A continuation byte of UTF-8 takes no column.
            width += !is_mark && c != '\r' && (static_cast<unsigned char>(c) & 0xc0) != 0x80;
            is_mark = is_mark && c != 'm';
        }
        longest = std::max(longest, width);
    }
    return longest;
}

TEST(Screen, is_as_wide_as_the_tables_and_the_help_on_it) {
    for (const Words& words :
         {Words{"encodings"}, {"engines"}, {"formats"}, {"operators"}, {"help"}}) {
        for (const int columns : {60, 100}) {
            const std::string text = on_terminal(columns, words);
            EXPECT_GT(text.size(), 500U) << words[0];
            EXPECT_LE(longest_line(text), static_cast<std::size_t>(columns)) << words[0] << '\n'
                                                                             << text;
        }
    }
    EXPECT_LE(longest_line(on_terminal(200, {"encodings"}, {"COLUMNS=70"})), 70U);
}

TEST(Screen, shows_colors_unless_it_has_none_or_they_are_unwanted) {
    EXPECT_TRUE(has_color(on_terminal(80, {"formats"})));
    EXPECT_TRUE(has_color(on_terminal(80, {"bake"})));
    EXPECT_TRUE(has_color(on_terminal(80, {"formats"}, {"NO_COLOR="}))) << "empty is unset";
    EXPECT_FALSE(has_color(on_terminal(80, {"formats"}, {"NO_COLOR=1"})));
    EXPECT_FALSE(has_color(on_terminal(80, {"bake"}, {"NO_COLOR=1"})));
    EXPECT_FALSE(has_color(on_terminal(80, {"formats"}, {"TERM=dumb"})));
}

TEST(Pipe, has_neither_width_nor_colors) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_EQ(terminal::columns_of(ends[1]), 0U);
    EXPECT_EQ(terminal::style_of(ends[1]).bad("x"), "x");
    ::close(ends[0]);
    ::close(ends[1]);
}

} // namespace
