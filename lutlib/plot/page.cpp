#include "lutlib/plot/page.h"

#include "lutlib/plot/axis.h"
#include "lutlib/plot/page_parts.h"

#include <fmt/core.h>

#include <algorithm>

namespace plot {
namespace {

std::string views_html(const Page& page) {
    if (page.views.empty()) {
        return "";
    }
    std::string rules, inputs, plots;
    for (std::size_t i = 0; i < page.views.size(); ++i) {
        rules += fmt::format("#view-{0}:checked ~ #plots-{0} {{ display: flex; }}\n", i);
        inputs +=
            fmt::format("<input class=\"view\" type=\"radio\" name=\"view\" id=\"view-{0}\"{1}>"
                        "<label class=\"view\" for=\"view-{0}\">{2}</label>\n",
                        i, i == 0 ? " checked" : "", escaped(page.views[i].name));
        plots += fmt::format("<div class=\"plots\" id=\"plots-{}\">\n", i);
        for (const std::string& element : page.views[i].plots) {
            plots += element;
        }
        plots += "</div>\n";
    }
    return "<style>" + rules + "</style>\n" + inputs + plots;
}

// Empty until a script fills it, since it does nothing without one.
std::string filters_html(const Table& table) {
    if (table.filters.empty()) {
        return "";
    }
    std::string out = "<span class=\"filters\" hidden>\n";
    for (const std::size_t column : table.filters) {
        out += fmt::format("<label>{0}<select data-column=\"{1}\"><option value=\"\">all</option>"
                           "</select></label>\n",
                           escaped(table.columns[column]), column);
    }
    return out + "</span>\n";
}

// Where something is dominated.
std::string front_toggle(const Table& table) {
    const bool any = std::any_of(table.rows.begin(), table.rows.end(),
                                 [](const Row& row) { return row.dominated; });
    return any ? "<input class=\"only\" type=\"checkbox\" id=\"front-only\">"
                 "<label class=\"only\" for=\"front-only\">the front only</label>\n"
               : "";
}

std::string cells_html(const std::vector<Cell>& cells) {
    std::string out;
    for (const Cell& cell : cells) {
        out += cell.numeric
                   ? fmt::format("<td data-v=\"{:.9g}\">{}</td>", cell.value, escaped(cell.text))
                   : "<td>" + escaped(cell.text) + "</td>";
    }
    return out;
}

std::string head_html(const std::vector<std::string>& columns, const std::vector<Cell>* first) {
    std::string out = "<thead><tr>";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool words = !first || !(*first)[i].numeric;
        out += (words ? "<th class=\"words\">" : "<th>") + escaped(columns[i]) + "</th>";
    }
    return out + "</tr></thead>\n";
}

std::string main_table(const Table& table) {
    std::string naming;
    for (const std::size_t column : table.naming) {
        naming += (naming.empty() ? "" : ",") + std::to_string(column);
    }
    std::string out =
        fmt::format("<table class=\"all\" data-naming=\"[{}]\">\n", naming) +
        head_html(table.columns, table.rows.empty() ? nullptr : &table.rows.front().cells) +
        "<tbody>\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const Row& row = table.rows[i];
        const char* const kind = row.recommended ? " class=\"recommended\""
                                 : row.dominated ? " class=\"dominated\""
                                                 : "";
        out += fmt::format("<tr id=\"row-{}\"{}>", i, kind) + cells_html(row.cells) + "</tr>\n";
    }
    return out + "</tbody>\n</table>\n";
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
        }
        // Nothing may look like the end of the element.
        out += c == '<' ? "\\u003c" : c == '\n' ? "\\n" : std::string(1, c);
    }
    return out + "\"";
}

// What scripts need of every row.
std::string panel_data(const Panels& panels) {
    std::string out = "<script type=\"application/json\" id=\"panels\">{\"values\":[";
    for (std::size_t i = 0; i < panels.values.size(); ++i) {
        out += fmt::format("{}[{},{}]", i ? "," : "", quoted(panels.values[i].id),
                           quoted(panels.values[i].kind));
    }
    out += "],\"rows\":[";
    for (std::size_t i = 0; i < panels.rows.size(); ++i) {
        out += i ? ",\n[" : "\n[";
        for (std::size_t k = 0; k < panels.rows[i].size(); ++k) {
            out += (k ? "," : "") + quoted(panels.rows[i][k]);
        }
        out += "]";
    }
    return out + "]}</script>\n";
}

} // namespace

Cell text_cell(const std::string& text) {
    return {text, 0, false};
}

Cell number_cell(double value) {
    return {fmt::format("{:.3g}", value), value, true};
}

std::string figures_html(const std::vector<Figure>& figures) {
    std::string out = "<div class=\"figures\">\n";
    for (const Figure& figure : figures) {
        const Drawing drawing = figure.is_wide
                                    ? drawing_of(figure, wide_figure_width, wide_figure_height)
                                    : drawing_of(figure);
        out += fmt::format("<div{}>\n", figure.is_wide ? " class=\"wide\"" : "") + svg(drawing) +
               "</div>\n";
    }
    return out + "</div>\n";
}

std::string table_html(const std::vector<std::string>& columns,
                       const std::vector<std::vector<Cell>>& rows) {
    std::string out =
        "<table>\n" + head_html(columns, rows.empty() ? nullptr : &rows.front()) + "<tbody>\n";
    for (const std::vector<Cell>& cells : rows) {
        out += "<tr>" + cells_html(cells) + "</tr>\n";
    }
    return out + "</tbody>\n</table>\n";
}

std::string html(const Page& page) {
    std::string out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                      "<meta name=\"viewport\" content=\"width=device-width\">\n"
                      "<meta name=\"generator\" content=\"lutconv\">\n<title>" +
                      escaped(page.title) + "</title>\n<style>" + page_style() +
                      "</style>\n</head>\n<body>\n";
    out += "<h1>" + escaped(page.title) + "</h1>\n<p class=\"summary\">" + escaped(page.summary) +
           "</p>\n<section>\n" + filters_html(page.table) + front_toggle(page.table) +
           views_html(page);
    if (!page.panels.markup.empty()) {
        out += page.panels.markup;
    }
    for (const std::string& section : page.sections) {
        out += section;
    }
    out += page.paragraphs.empty() ? "" : "<h2>How it was measured</h2>\n";
    for (const std::string& paragraph : page.paragraphs) {
        out += "<p>" + escaped(paragraph) + "</p>\n";
    }
    if (page.table.columns.empty()) {
        return out + "</section>\n</body>\n</html>\n";
    }
    out += "<p class=\"on-paper\">On paper the table leaves out what is dominated.</p>\n" +
           main_table(page.table) + "</section>\n";
    if (!page.panels.rows.empty()) {
        out += panel_data(page.panels);
    }
    return out + "<script>" + page_script() + "</script>\n</body>\n</html>\n";
}

} // namespace plot
