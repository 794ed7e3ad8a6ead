// One self-contained HTML page: text, plots that can be switched without scripts, panels about one
// row, and a table that scripts make sortable. Loads nothing; everything but filters, sorting and
// other rows' panels works without scripts; prints with the dominated rows left out.
#pragma once

#include "lutlib/plot/figure.h"

#include <cstddef>
#include <string>
#include <utility>
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
    /// Columns by whose values rows and marks can be filtered.
    std::vector<std::size_t> filters;
    /// Columns that name a row, in order.
    std::vector<std::size_t> naming;
};

/// Plots that are shown together, one view at a time; the first is shown at the start.
struct View {
    std::string name;
    std::vector<std::string> plots; ///< <svg> elements
};

/// What is shown of one row at a time: markup for the row that is shown first, and for scripts
/// every row's. An element with an id "d-NAME" gets the row's value of NAME:
///   cells   letters of levels (heat_map.h), for an <svg class="heat">
///   bands   the same, three letters a column
///   path    the "d" of a <path>
///   text    the text of an element
struct Panels {
    struct Value {
        std::string id, kind;
    };
    std::string markup;
    std::vector<Value> values;
    std::vector<std::vector<std::string>> rows; ///< of each row of the table, in order of `values`
};

/// What is empty is left out, and without a table there is no script.
struct Page {
    std::string title;
    std::string summary;                 ///< the one sentence
    std::vector<std::string> paragraphs; ///< the method and whatever must be known
    std::vector<View> views;
    Panels panels;
    std::vector<std::string> sections; ///< markup between the panels and the table
    Table table;
};

std::string html(const Page& page);

/// Figures beside each other, as markup for Page::sections; wide ones take a row.
std::string figures_html(const std::vector<Figure>& figures);

/// A small table of its own, as markup for Page::sections.
std::string table_html(const std::vector<std::string>& columns,
                       const std::vector<std::vector<Cell>>& rows);

} // namespace plot
