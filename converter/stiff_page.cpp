#include "converter/stiff_page.h"

#include "converter/report.h"
#include "converter/survey_columns.h"
#include "lutlib/plot/page.h"
#include "lutlib/plot/scatter.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace converter {
namespace {

// The middle look's mean error of a lookup at 16 nodes, over the looks of a range of stiffness.
double typical_error(const lutlib::StiffSurvey& survey, const lutlib::Lookup& lookup, double low,
                     double high) {
    std::vector<double> means;
    for (const lutlib::StiffRow& row : survey.rows) {
        if (row.size == 16 && row.lookup == &lookup && !row.fitted && row.stiffness >= low &&
            row.stiffness < high) {
            means.push_back(row.error.mean);
        }
    }
    std::sort(means.begin(), means.end());
    return means.empty() ? 0 : means[means.size() / 2];
}

std::string stiff_summary(const lutlib::StiffSurvey& survey) {
    std::string out = "Mean error of the middle look at 16 nodes, for stiffness above 1 to 4, 4 to "
                      "40, and beyond";
    const char* separator = ": ";
    for (const lutlib::Lookup& lookup : lutlib::lookups()) {
        out += fmt::format("{}{} {:.2g} %, {:.2g} %, {:.2g} %", separator, lookup.label,
                           100 * typical_error(survey, lookup, 1.01, 4),
                           100 * typical_error(survey, lookup, 4, 40),
                           100 * typical_error(survey, lookup, 40, INFINITY));
        separator = "; ";
    }
    return out + ".";
}

std::string stiff_label(const lutlib::StiffRow& row) {
    return fmt::format("{}: {} nodes, {}{}", row.look->name, row.size, row.lookup->label,
                       row.fitted ? ", fitted" : "");
}

} // namespace

std::string stiff_html(const lutlib::StiffSurvey& survey) {
    plot::Page page;
    page.title = "Error against stiffness";
    page.summary = stiff_summary(survey);
    page.paragraphs = {
        fmt::format(
            "Each look of the suite of stiff and extreme looks, read in double, against its "
            "resampling in floats; {} colours a look. An error is a share of the look's "
            "output range (of its magnitude, where it is constant). Stiffness is the "
            "steepest edge between neighbouring nodes, in output ranges per width of the "
            "domain: 1 is the identity's. A mark at the plot's lower edge is an error below its "
            "scale, one at the left edge a look that is constant.",
            survey.colours),
        fmt::format("Machine: {}.", lutlib::machine_text())};
    const std::array<std::pair<const char*, double (*)(const lutlib::ErrorStats&)>, 3> shown{{
        {"mean error", [](const lutlib::ErrorStats& e) { return e.mean; }},
        {"p99 error", [](const lutlib::ErrorStats& e) { return e.p99; }},
        {"max error", [](const lutlib::ErrorStats& e) { return e.max; }},
    }};
    for (const auto& [name, value] : shown) {
        plot::View view{name, {}};
        for (const int size : {16, 33}) {
            plot::Scatter scatter;
            scatter.title = fmt::format("{} against stiffness, {} nodes", name, size);
            scatter.x_label = "stiffness";
            scatter.y_label = std::string(name) + ", share of the output range";
            scatter.series = lookup_series();
            scatter.circle_name = "point-sampled";
            scatter.diamond_name = "fitted";
            scatter.y_floor = 1e-6;
            for (std::size_t i = 0; i < survey.rows.size(); ++i) {
                const lutlib::StiffRow& row = survey.rows[i];
                if (row.size == size) {
                    scatter.marks.push_back(
                        {.x = row.stiffness,
                         .y = value(row.error),
                         .series = lookup_index(*row.lookup),
                         .diamond = row.fitted,
                         .label = fmt::format("{}: {} {:.3g}, stiffness {:.3g}", stiff_label(row),
                                              name, value(row.error), row.stiffness),
                         .row = i});
                }
            }
            view.plots.push_back(svg(scatter));
        }
        page.views.push_back(std::move(view));
    }
    page.table.columns = {"look",    "what it is", "stiffness", "nodes",     "lookup",
                          "filling", "max",        "p99",       "mean error"};
    for (const lutlib::StiffRow& row : survey.rows) {
        plot::Row cells;
        cells.cells = {plot::text_cell(std::string(row.look->name)),
                       plot::text_cell(std::string(row.look->help)),
                       plot::number_cell(row.stiffness),
                       {std::to_string(row.size), static_cast<double>(row.size), true},
                       plot::text_cell(std::string(row.lookup->label)),
                       plot::text_cell(row.fitted ? "fitted" : "point-sampled"),
                       plot::number_cell(row.error.max),
                       plot::number_cell(row.error.p99),
                       plot::number_cell(row.error.mean)};
        page.table.rows.push_back(std::move(cells));
    }
    return html(page);
}

nlohmann::ordered_json stiff_json(const lutlib::StiffSurvey& survey) {
    nlohmann::ordered_json out{{"machine", lutlib::machine_text()}, {"colours", survey.colours}};
    for (const lutlib::StiffRow& row : survey.rows) {
        out["rows"].push_back({{"look", row.look->name},
                               {"stiffness", row.stiffness},
                               {"size", row.size},
                               {"lookup", row.lookup->name},
                               {"filling", row.fitted ? "fitted" : "point-sampled"},
                               {"error", to_json(row.error)}});
    }
    return out;
}

std::string stiff_csv(const lutlib::StiffSurvey& survey) {
    std::string out =
        csv_line({"look", "stiffness", "size", "lookup", "filling", "max", "p99", "mean"});
    for (const lutlib::StiffRow& row : survey.rows) {
        out +=
            csv_line({std::string(row.look->name), fmt::format("{:.9g}", row.stiffness),
                      std::to_string(row.size), std::string(row.lookup->name),
                      row.fitted ? "fitted" : "point-sampled", fmt::format("{:.9g}", row.error.max),
                      fmt::format("{:.9g}", row.error.p99), fmt::format("{:.9g}", row.error.mean)});
    }
    return out;
}

} // namespace converter
