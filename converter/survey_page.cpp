#include "converter/survey_page.h"

#include "converter/report.h"
#include "lutlib/plot/page.h"
#include "lutlib/plot/scatter.h"
#include "lutlib/survey/pareto.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace converter {
namespace {

using lutlib::Survey;
using lutlib::SurveyRow;

struct Metric {
    const char* name;
    double (*of)(const lutlib::Difference& d);
};
// The first is what recommendations and dominance go by.
constexpr std::array<Metric, 9> metrics{{
    {"dE2000 max", [](const lutlib::Difference& d) { return d.delta_e_2000.max; }},
    {"dE2000 p99", [](const lutlib::Difference& d) { return d.delta_e_2000.p99; }},
    {"dE2000 mean", [](const lutlib::Difference& d) { return d.delta_e_2000.mean; }},
    {"abs max", [](const lutlib::Difference& d) { return d.absolute.max; }},
    {"abs p99", [](const lutlib::Difference& d) { return d.absolute.p99; }},
    {"abs mean", [](const lutlib::Difference& d) { return d.absolute.mean; }},
    {"dE-ITP max", [](const lutlib::Difference& d) { return d.delta_e_itp.max; }},
    {"dE-ITP p99", [](const lutlib::Difference& d) { return d.delta_e_itp.p99; }},
    {"dE-ITP mean", [](const lutlib::Difference& d) { return d.delta_e_itp.mean; }},
}};
constexpr std::array<std::size_t, 5> plotted{0, 1, 2, 5, 7};

struct Cost {
    const char* label;
    double (*of)(const SurveyRow& row);
};
constexpr std::array<Cost, 2> costs{{
    {"nanoseconds a pixel, one core", [](const SurveyRow& r) { return 1e9 * r.pixel.median; }},
    {"bytes", [](const SurveyRow& r) { return static_cast<double>(r.bytes); }},
}};

std::vector<std::size_t> dominators_of(const Survey& survey) {
    std::vector<std::array<double, 3>> points;
    for (const SurveyRow& row : survey.rows) {
        points.push_back({metrics[0].of(row.error), costs[0].of(row), costs[1].of(row)});
    }
    return lutlib::dominators<3>(points);
}

std::size_t lookup_index(const lutlib::Lookup& lookup) {
    return static_cast<std::size_t>(&lookup - lutlib::lookups().data());
}

std::vector<plot::Series> lookup_series() {
    std::vector<plot::Series> out;
    for (const lutlib::Lookup& lookup : lutlib::lookups()) {
        out.push_back({std::string(lookup.label)});
    }
    return out;
}

std::string figures(const SurveyRow& row) {
    const auto& e = row.error.delta_e_2000;
    return fmt::format("dE2000 max {:.3g}, p99 {:.3g}, mean {:.3g}; {} bytes; {:.3g} ns a pixel",
                       e.max, e.p99, e.mean, row.bytes, 1e9 * row.pixel.median);
}

plot::Scatter scatter(const Survey& survey, const Metric& metric, const Cost& cost,
                      std::size_t recommended) {
    plot::Scatter out;
    out.title = fmt::format("{} against {}", metric.name, cost.label);
    out.x_label = cost.label;
    out.y_label = metric.name;
    out.series = lookup_series();
    out.circle_name = "point-sampled";
    out.diamond_name = "fitted";
    std::vector<std::array<double, 2>> points;
    for (const SurveyRow& row : survey.rows) {
        points.push_back({cost.of(row), metric.of(row.error)});
    }
    const std::vector<std::size_t> by = lutlib::dominators<2>(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurveyRow& row = survey.rows[i];
        out.marks.push_back({points[i][0], points[i][1], lookup_index(*row.what.lookup),
                             row.what.fitted, by[i] == lutlib::not_dominated, i == recommended,
                             by[i] != lutlib::not_dominated && i != recommended,
                             fmt::format("{}: {} {:.3g}, {:.4g} {}", to_text(row.what), metric.name,
                                         points[i][1], points[i][0], cost.label),
                             i});
    }
    return out;
}

// How results outside 0..1 are taken.
std::string range_text(const Survey& survey) {
    const std::string outside =
        survey.outside.share > 0
            ? fmt::format("{:.3g} % of the colours have a channel outside 0..1, by {:.3g} at most",
                          100 * survey.outside.share, survey.outside.most)
            : "none of the look's results lies outside 0..1";
    if (survey.clamped) {
        return "Range: the look and every result are held to 0..1, as a display holds them; " +
               outside + " (--unclamped judges that too).";
    }
    return survey.settings.unclamped
               ? "Range: --unclamped: results are judged as they are, outside 0..1 too, which no "
                 "display shows; " +
                     outside + "."
               : "Range: the output is no display's, so results are judged as they are, outside "
                 "0..1 too.";
}

std::vector<std::string> method(const Survey& survey) {
    const lutlib::SurveySettings& s = survey.settings;
    std::vector<std::string> out{
        fmt::format("Machine: {}.", lutlib::machine_text()),
        fmt::format("Errors: {} colours (1024 neutrals, the corners, the rest spread evenly over "
                    "the domain) against the look evaluated exactly in double. abs is the largest "
                    "channel difference in code values; dE-ITP takes code 1 for 100 cd/m2.",
                    survey.colours),
        fmt::format(
            "Time: what lutconv apply does, on one of the cores and with its vectors, over {} "
            "pixels whose colours are spread evenly in no order, which is the hardest for caches; "
            "in each of {} rounds every combination once, warmed; the median, the interval that "
            "holds it with 95 %, and the best. Pixels do not wait for each "
            "other, so that more cores take so much less time as long as memory keeps up. It "
            "depends on size, 1D table, storage and lookup, "
            "not on the values, and was measured once for each of these.",
            s.pixels, s.rounds),
        "Bytes: of the nodes as stored, and 12 for each entry of the 1D table where there is one: "
        "1024, or as many as the look's own has. Bake time: one run, all cores.",
        "Dominated: another combination is no worse in largest dE2000, time and bytes, and better "
        "in one. The dashed line joins what no other beats in the plot's own two measures."};
    out.push_back(range_text(survey));
    for (const std::string& note : survey.notes) {
        out.push_back("Note: " + note + ".");
    }
    return out;
}

plot::Table table(const Survey& survey, std::size_t recommended) {
    plot::Table out;
    out.columns = {"combination"};
    for (const Metric& metric : metrics) {
        out.columns.emplace_back(metric.name);
    }
    for (const char* name : {"bytes", "ns a pixel", "95 % of it", "bake ms", "dominated by"}) {
        out.columns.emplace_back(name);
    }
    const std::vector<std::size_t> by = dominators_of(survey);
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        const SurveyRow& row = survey.rows[i];
        plot::Row cells{
            {plot::text_cell(to_text(row.what))}, by[i] != lutlib::not_dominated, i == recommended};
        for (const Metric& metric : metrics) {
            cells.cells.push_back(plot::number_cell(metric.of(row.error)));
        }
        cells.cells.push_back({std::to_string(row.bytes), costs[1].of(row), true});
        cells.cells.push_back(plot::number_cell(costs[0].of(row)));
        cells.cells.push_back(
            {fmt::format("{:.3g} to {:.3g}", 1e9 * row.pixel.low, 1e9 * row.pixel.high),
             1e9 * row.pixel.low, true});
        cells.cells.push_back(plot::number_cell(1e3 * row.bake_seconds));
        cells.cells.push_back(plot::text_cell(cells.dominated ? to_text(survey.rows[by[i]].what)
                                                              : "nothing: on the front"));
        out.rows.push_back(std::move(cells));
    }
    return out;
}

std::string csv_line(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) {
        out += (out.empty() ? "" : ",") + word;
    }
    return out + "\n";
}

nlohmann::ordered_json row_json(const SurveyRow& row) {
    return {{"size", row.what.size},
            {"shaper", row.what.shaper->name},
            {"storage", row.what.storage->name},
            {"lookup", row.what.lookup->name},
            {"filling", row.what.fitted ? "fitted" : "point-sampled"},
            {"absolute", to_json(row.error.absolute)},
            {"delta_e_2000", to_json(row.error.delta_e_2000)},
            {"delta_e_itp", to_json(row.error.delta_e_itp)},
            {"bytes", row.bytes},
            {"bake_seconds", row.bake_seconds},
            {"ns_per_pixel",
             {{"median", 1e9 * row.pixel.median},
              {"low_95", 1e9 * row.pixel.low},
              {"high_95", 1e9 * row.pixel.high},
              {"best", 1e9 * row.pixel.best},
              {"repetitions", row.pixel.repetitions},
              {"emulated", lutlib::is_emulated(*row.what.lookup)}}}};
}

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

std::string recommendation_text(const Survey& survey) {
    const lutlib::Recommendation& r = survey.recommendation;
    const double promise = survey.settings.promise;
    const SurveyRow& best = survey.rows[r.row];
    if (!r.kept) {
        return fmt::format("No combination stays within dE2000 {:g}; {} comes nearest: {}.",
                           promise, to_text(best.what), figures(best));
    }
    std::string out = fmt::format("Take {}, the smallest that stays within dE2000 {:g} (also on {} "
                                  "other colours and uphill from the worst of them): {}",
                                  to_text(best.what), promise, survey.checked, figures(best));
    const SurveyRow& fastest = survey.rows[r.fastest];
    return out + (r.fastest == r.row ? "; nothing faster does so either."
                                     : fmt::format("; the fastest that does so is {} ({:.3g} ns a "
                                                   "pixel, {} bytes).",
                                                   to_text(fastest.what),
                                                   1e9 * fastest.pixel.median, fastest.bytes));
}

std::string survey_html(const Survey& survey, const std::string& look) {
    plot::Page page;
    const std::size_t recommended = survey.recommendation.row;
    page.title = "Error against run time: " + look;
    page.summary = recommendation_text(survey);
    page.paragraphs = method(survey);
    for (const std::size_t i : plotted) {
        plot::View view{metrics[i].name, {}};
        for (const Cost& cost : costs) {
            view.plots.push_back(svg(scatter(survey, metrics[i], cost, recommended)));
        }
        page.views.push_back(std::move(view));
    }
    page.table = table(survey, recommended);
    return html(page);
}

nlohmann::ordered_json survey_json(const Survey& survey, const std::string& look) {
    const lutlib::Recommendation& r = survey.recommendation;
    nlohmann::ordered_json out{
        {"look", look},
        {"machine", lutlib::machine_text()},
        {"colours", survey.colours},
        {"timed_pixels", survey.settings.pixels},
        {"clamped", survey.clamped},
        {"outside_display", {{"share", survey.outside.share}, {"most", survey.outside.most}}},
        {"notes", survey.notes},
        {"recommendation",
         {{"words", recommendation_text(survey)},
          {"row", r.row},
          {"promise_delta_e_2000", survey.settings.promise},
          {"checked_colours", survey.checked},
          {"kept", r.kept}}}};
    const std::vector<std::size_t> by = dominators_of(survey);
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        nlohmann::ordered_json row = row_json(survey.rows[i]);
        row["on_front"] = by[i] == lutlib::not_dominated;
        if (by[i] != lutlib::not_dominated) {
            row["dominated_by"] = by[i];
        }
        out["rows"].push_back(std::move(row));
    }
    return out;
}

std::string survey_csv(const Survey& survey) {
    std::vector<std::string> head{"size", "shaper", "storage", "lookup", "filling"};
    for (const Metric& metric : metrics) {
        head.emplace_back(metric.name);
    }
    for (const char* name : {"bytes", "bake_seconds", "ns_per_pixel", "ns_low_95", "ns_high_95",
                             "ns_best", "ns_emulated", "on_front"}) {
        head.emplace_back(name);
    }
    std::string out = csv_line(head);
    const std::vector<std::size_t> by = dominators_of(survey);
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        const SurveyRow& row = survey.rows[i];
        std::vector<std::string> words{
            std::to_string(row.what.size), std::string(row.what.shaper->name),
            std::string(row.what.storage->name), std::string(row.what.lookup->name),
            row.what.fitted ? "fitted" : "point-sampled"};
        for (const Metric& metric : metrics) {
            words.push_back(fmt::format("{:.9g}", metric.of(row.error)));
        }
        words.push_back(std::to_string(row.bytes));
        for (const double value : {row.bake_seconds, 1e9 * row.pixel.median, 1e9 * row.pixel.low,
                                   1e9 * row.pixel.high, 1e9 * row.pixel.best}) {
            words.push_back(fmt::format("{:.6g}", value));
        }
        words.emplace_back(lutlib::is_emulated(*row.what.lookup) ? "1" : "0");
        words.emplace_back(by[i] == lutlib::not_dominated ? "1" : "0");
        out += csv_line(words);
    }
    return out;
}

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
            scatter.series_gap = 4;
            for (std::size_t i = 0; i < survey.rows.size(); ++i) {
                const lutlib::StiffRow& row = survey.rows[i];
                if (row.size == size) {
                    scatter.marks.push_back(
                        {row.stiffness, value(row.error), lookup_index(*row.lookup), row.fitted,
                         false, false, false,
                         fmt::format("{}: {} {:.3g}, stiffness {:.3g}", stiff_label(row), name,
                                     value(row.error), row.stiffness),
                         i});
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
