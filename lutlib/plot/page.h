// One self-contained HTML page: text, plots that can be switched without scripts, and a table that
// scripts make sortable. Loads nothing, and prints with the dominated rows left out.
#pragma once

#include <string>
#include <vector>

namespace plot {

struct Cell {
    std::string text;
    double value = 0; ///< to sort by, where `numeric`
    bool numeric = false;
};
Cell text_cell(const std::string& text);
/// Three significant digits.
Cell number_cell(double value);

struct Row {
    std::vector<Cell> cells;
    bool dominated = false; ///< pale, and not printed
    bool recommended = false;
};

struct Table {
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

/// Plots that are shown together, one view at a time; the first is shown at the start.
struct View {
    std::string name;
    std::vector<std::string> plots; ///< <svg> elements
};

struct Page {
    std::string title;
    std::string summary;                 ///< the one sentence
    std::vector<std::string> paragraphs; ///< the method and whatever must be known
    std::vector<View> views;
    Table table;
};

std::string html(const Page& page);

} // namespace plot
