#include "terminal/table.h"

#include "lutlib/io/terminal.h"
#include "lutlib/text.h"

#include <algorithm>
#include <unistd.h>

namespace terminal {
namespace {

constexpr std::size_t between = 2, least_last = 28, help_column = 30;

// Characters, each of which takes a column in our tables.
std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

std::size_t leading_blanks(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

// Where the words of a line of CLI11's help begin that what goes on stands under.
std::size_t hang_of(std::string_view line) {
    const std::size_t own = leading_blanks(line);
    const bool is_described = own == between && line.size() > help_column &&
                              line[help_column - 1] == ' ' && line[help_column] != ' ';
    return is_described ? help_column : own;
}

} // namespace

std::string wrapped(std::string_view line, std::size_t hang, std::size_t columns,
                    std::size_t begun) {
    std::string out(line.substr(0, leading_blanks(line)));
    std::size_t at = begun + out.size();
    line.remove_prefix(out.size());
    for (bool is_first = true; !line.empty(); is_first = false) {
        const std::size_t blanks = leading_blanks(line);
        const std::size_t end = std::min(line.find(' ', blanks), line.size());
        const std::string_view word = line.substr(blanks, end - blanks);
        const std::size_t width = width_of(word);
        const bool is_full = columns > 0 && at + blanks + width > columns;
        if (is_full && !is_first && at > hang) {
            out += '\n' + std::string(hang, ' ');
            at = hang + width;
        } else {
            out.append(blanks, ' ');
            at += blanks + width;
        }
        out += word;
        line.remove_prefix(end);
    }
    return out;
}

std::string wrapped_help(std::string_view help, std::size_t columns) {
    std::string out;
    bool in_examples = false;
    lutlib::LineScanner lines(help);
    for (std::string_view line; lines.next(line);) {
        in_examples = in_examples || line == "Examples:";
        out += in_examples ? std::string(line) : wrapped(line, hang_of(line), columns);
        out += '\n';
    }
    return out;
}

void Table::heading(const std::string& text) {
    lines_.push_back({true, {lutlib::io::shown_text(text)}});
}

void Table::row(const std::vector<std::string>& cells) {
    Line line;
    for (const std::string& cell : cells) {
        line.cells.push_back(lutlib::io::shown_text(cell));
    }
    while (line.cells.size() > 1 && line.cells.back().empty()) {
        line.cells.pop_back();
    }
    lines_.push_back(std::move(line));
}

std::size_t Table::indent() const {
    const bool has_headings =
        std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.is_heading; });
    return has_headings ? between : 0;
}

std::vector<std::size_t> Table::starts(std::size_t columns) const {
    std::vector<std::size_t> widths;
    for (const Line& line : lines_) {
        widths.resize(std::max(widths.size(), line.is_heading ? 0 : line.cells.size()));
        for (std::size_t i = 0; !line.is_heading && i < line.cells.size(); ++i) {
            widths[i] = std::max(widths[i], width_of(line.cells[i]));
        }
    }
    std::vector<std::size_t> out{indent()};
    for (const std::size_t width : widths) {
        out.push_back(out.back() + width + between);
    }
    const std::size_t end = out.back() - between;
    out.pop_back();
    if (columns > 0 && out.size() > 1 && end > columns && out.back() + least_last > columns) {
        const std::size_t below = out[1] + least_last > columns ? indent() + between : out[1];
        std::fill(out.begin() + 1, out.end(), below);
    }
    return out;
}

std::string Table::text(std::size_t columns, const Style& style) const {
    const std::vector<std::size_t> start = starts(columns);
    std::string out;
    for (const Line& line : lines_) {
        if (line.is_heading) {
            out += style.heading(wrapped(line.cells.front(), between, columns)) + '\n';
            continue;
        }
        std::size_t at = 0;
        for (std::size_t i = 0; i < line.cells.size(); ++i) {
            const std::string& cell = line.cells[i];
            if (at > start[i]) {
                out += '\n';
                at = 0;
            }
            out.append(start[i] - at, ' ');
            out += i == 0 ? style.name(cell) : wrapped(cell, start[i], columns, start[i]);
            at = start[i] + width_of(cell);
        }
        out += '\n';
    }
    return out;
}

void print(const Table& table) {
    lutlib::io::print_marked(table.text(columns_of(STDOUT_FILENO), style_of(STDOUT_FILENO)));
}

} // namespace terminal
