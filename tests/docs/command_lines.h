// The command lines that a Markdown document shows in its indented code blocks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace docs_test {

struct CommandLine {
    std::string text; ///< for a shell: without the block's indentation, its comment with it
    std::size_t line = 0;

    /// What the text says behind "#"; empty where it says nothing.
    std::string comment() const;
};

/// In order. A command may go on over lines that end in a backslash, and within quotes.
std::vector<CommandLine> command_lines(std::string_view markdown);

} // namespace docs_test
