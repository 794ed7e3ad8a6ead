#include "lutlib/plot/page.h"

#include "lutlib/plot/scatter.h"

#include <fmt/core.h>

namespace plot {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 1560px; margin: 1.5em auto; padding: 0 1em;
       color: #222; background: #fff; }
h1 { font-size: 1.4em; }
.summary { font-size: 1.1em; border-left: 4px solid #009E73; padding: .3em .8em; background: #f3f8f6; }
.plots { display: none; flex-wrap: wrap; gap: 1em; }
.plots svg { flex: 1 1 560px; max-width: 100%; border: 1px solid #ddd; }
svg text { font: 15px system-ui, sans-serif; fill: #222; }
svg .title { font-weight: 600; font-size: 17px; }
svg tspan { font-size: 11px; }
.grid { stroke: #e6e6e6; fill: none; }
.frame { stroke: #777; fill: none; }
.front { stroke: #222; stroke-width: 1.8; fill: none; stroke-dasharray: 6 3; }
.mark { opacity: .36; }
.mark.top, .mark.best { opacity: 1; stroke: #222; stroke-width: .7; }
.mark.best { stroke-width: 2.5; }
.mark:hover { opacity: 1; stroke: #000; stroke-width: 1.5; }
.outline { fill: none; stroke: #333; }
input.view { margin-left: 1.2em; }
table { border-collapse: collapse; font-size: 12px; margin-top: 1em; }
th, td { padding: .15em .45em; text-align: right; border-bottom: 1px solid #eee; white-space: nowrap; }
td:not([data-v]) { text-align: left; }
th.words { text-align: left; }
th { position: sticky; top: 0; background: #f5f5f5; vertical-align: bottom; }
th[role=button] { cursor: pointer; }
tr.dominated { color: #6b6b6b; }
tr.recommended td { background: #e3f4ec; font-weight: 600; }
tr.picked td { background: #fff3c4; }
.on-paper { display: none; }
@media print {
  body { font-size: 11px; max-width: none; }
  tr.dominated, input.view, label.view { display: none; }
  .on-paper { display: block; }
  th { position: static; }
  td { white-space: normal; }
  .plots { break-inside: avoid; }
  .mark { opacity: .5; }
}
)";

// Sorting by a click on a heading, and from a mark to its row.
constexpr const char* script = R"(
const table = document.querySelector('table'), body = table.tBodies[0];
const key = (row, i) => { const c = row.cells[i]; return c.dataset.v === undefined ? c.textContent : +c.dataset.v; };
let sorted = -1, down = false;
[...table.tHead.rows[0].cells].forEach((th, i) => {
  th.setAttribute('role', 'button'); th.tabIndex = 0; th.title = 'sort';
  const sort = () => {
    down = sorted === i && !down; sorted = i;
    const rows = [...body.rows].sort((a, b) => { const x = key(a, i), y = key(b, i); return x < y ? -1 : x > y ? 1 : 0; });
    if (down) rows.reverse();
    body.append(...rows);
  };
  th.addEventListener('click', sort);
  th.addEventListener('keydown', e => { if (e.key === 'Enter') sort(); });
});
document.querySelectorAll('.mark').forEach(mark => mark.addEventListener('click', () => {
  document.querySelectorAll('tr.picked').forEach(r => r.classList.remove('picked'));
  const row = document.getElementById('row-' + mark.dataset.row);
  if (row) { row.classList.add('picked'); row.scrollIntoView({block: 'center'}); }
}));
)";

std::string views_html(const std::vector<View>& views) {
    std::string rules, inputs, plots;
    for (std::size_t i = 0; i < views.size(); ++i) {
        rules += fmt::format("#view-{0}:checked ~ #plots-{0} {{ display: flex; }}\n", i);
        inputs +=
            fmt::format("<input class=\"view\" type=\"radio\" name=\"view\" id=\"view-{0}\"{1}>"
                        "<label class=\"view\" for=\"view-{0}\">{2}</label>\n",
                        i, i == 0 ? " checked" : "", escaped(views[i].name));
        plots += fmt::format("<div class=\"plots\" id=\"plots-{}\">\n", i);
        for (const std::string& element : views[i].plots) {
            plots += element;
        }
        plots += "</div>\n";
    }
    return "<style>" + rules + "</style>\n<section>\n" + inputs + plots + "</section>\n";
}

std::string table_html(const Table& table) {
    std::string out = "<table>\n<thead><tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool words = table.rows.empty() || !table.rows.front().cells[i].numeric;
        out += (words ? "<th class=\"words\">" : "<th>") + escaped(table.columns[i]) + "</th>";
    }
    out += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const Row& row = table.rows[i];
        const char* const kind = row.recommended ? " class=\"recommended\""
                                 : row.dominated ? " class=\"dominated\""
                                                 : "";
        out += fmt::format("<tr id=\"row-{}\"{}>", i, kind);
        for (const Cell& cell : row.cells) {
            out += cell.numeric ? fmt::format("<td data-v=\"{:.9g}\">{}</td>", cell.value,
                                              escaped(cell.text))
                                : "<td>" + escaped(cell.text) + "</td>";
        }
        out += "</tr>\n";
    }
    return out + "</tbody>\n</table>\n";
}

} // namespace

Cell text_cell(const std::string& text) {
    return {text, 0, false};
}

Cell number_cell(double value) {
    return {fmt::format("{:.3g}", value), value, true};
}

std::string html(const Page& page) {
    std::string out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
                      escaped(page.title) + "</title>\n<style>" + style +
                      "</style>\n</head>\n<body>\n";
    out += "<h1>" + escaped(page.title) + "</h1>\n<p class=\"summary\">" + escaped(page.summary) +
           "</p>\n";
    out += views_html(page.views);
    for (const std::string& paragraph : page.paragraphs) {
        out += "<p>" + escaped(paragraph) + "</p>\n";
    }
    out += "<p class=\"on-paper\">On paper the table leaves out what is dominated.</p>\n";
    return out + table_html(page.table) + "<script>" + script + "</script>\n</body>\n</html>\n";
}

} // namespace plot
