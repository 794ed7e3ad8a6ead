#include "tests/docs/command_lines.h"

#include "lutlib/text.h"

namespace docs_test {
namespace {

constexpr std::string_view indentation = "    ";

/// Where the shell's comment begins; npos without one. `open` tells whether a quote stays open.
std::size_t comment_start(std::string_view text, bool& open) {
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            quote = c == quote ? '\0' : quote;
        } else if (c == '\'' || c == '"') {
            quote = c;
        } else if (c == '#' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\n')) {
            open = false;
            return i;
        }
    }
    open = quote != 0;
    return std::string_view::npos;
}

bool goes_on(std::string_view text) {
    bool open = false;
    comment_start(text, open);
    return open || text.ends_with('\\');
}

} // namespace

std::string CommandLine::comment() const {
    bool open = false;
    const std::size_t at = comment_start(text, open);
    return at == std::string::npos ? "" : text.substr(at + 1);
}

std::vector<CommandLine> command_lines(std::string_view markdown) {
    std::vector<CommandLine> out;
    lutlib::LineScanner lines(markdown);
    bool in_block = false, after_blank = true, open = false;
    for (std::string_view line; lines.next(line);) {
        const bool blank = lutlib::trimmed(line).empty();
        // An indented line begins a block only behind a blank one; else it belongs to a paragraph.
        in_block = line.starts_with(indentation) && !blank && (in_block || after_blank);
        after_blank = blank;
        if (!in_block) {
            open = false;
            continue;
        }
        line.remove_prefix(indentation.size());
        if (open) {
            out.back().text += '\n' + std::string(line);
        } else {
            out.push_back({std::string(line), lines.line_number()});
        }
        open = goes_on(out.back().text);
    }
    return out;
}

} // namespace docs_test
