// Tables for people: columns under each other, and on a terminal no line longer than it is wide.
#pragma once

#include "terminal/style.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace terminal {

/// A line that is broken at blanks where it would be longer than `columns`, 0: never; what goes on
/// is indented by `hang`. `begun` columns stand before it. A word that is too long by itself stays
/// whole.
std::string wrapped(std::string_view line, std::size_t hang, std::size_t columns,
                    std::size_t begun = 0);

/// Every line of a program's help wrapped(), under its own description; examples stay as they can
/// be copied.
std::string wrapped_help(std::string_view help, std::size_t columns);

class Table {
  public:
    /// A line over the rows that follow.
    void heading(const std::string& text);
    /// Cells of a line; control characters are spelled out as by io::shown_text().
    void row(const std::vector<std::string>& cells);

    /// Every line with its end. Columns are as wide as their longest cell. Where `columns` (0: no
    /// bound) leaves the last one no room, it is wrapped, or cells stand under each other behind
    /// the first.
    std::string text(std::size_t columns = 0, const Style& style = Style()) const;

  private:
    struct Line {
        bool is_heading = false;
        std::vector<std::string> cells;
    };

    std::size_t indent() const;
    /// Where each column begins.
    std::vector<std::size_t> starts(std::size_t columns) const;

    std::vector<Line> lines_;
};

/// On standard output, as wide as that is. Throws lutlib::Error when it cannot be written.
void print(const Table& table);

} // namespace terminal
