#include "preview/report/page_sections.h"

#include "lutlib/plot/lines.h"
#include "lutlib/plot/page.h"
#include "preview/report/columns.h"

#include <fmt/format.h>

namespace preview::report {

namespace {

using plot::number_cell;
using plot::text_cell;
using Cells = std::vector<std::vector<plot::Cell>>;

std::string section(const std::string& title, const std::string& words) {
    return "<h2>" + plot::escaped(title) + "</h2>\n<p>" + plot::escaped(words) + "</p>\n";
}

std::string interval(const lutlib::Timing& time) {
    return fmt::format("{:.3g} ({:.3g} to {:.3g})", 1e3 * time.median, 1e3 * time.low,
                       1e3 * time.high);
}

std::string knees_section(const RendererReport& report) {
    Cells rows;
    std::size_t first = 0;
    for (const std::span<const Row> group : groups_of(report)) {
        const Row& any = group.front();
        const Row* const knee = knee_of(group, first);
        const Row* const usual = usual_row(group);
        if (any.input == report.input && usual != nullptr) {
            const auto index = static_cast<std::size_t>(usual - report.rows.data());
            rows.push_back({text_cell(std::string(any.study->title)),
                            text_cell(size_text(any.size)), text_cell(usual->variant),
                            text_cell(is_on_front(*usual, index)
                                          ? "yes"
                                          : "no: " + report.rows[usual->dominated_by].variant),
                            text_cell(knee == nullptr ? "none" : knee->variant)});
        }
        first += group.size();
    }
    return section("Defaults and knees",
                   "The setting that is taken where nobody asks for another, whether any other of "
                   "its pass is both faster and nearer, and the knee of the front: behind it more "
                   "time buys least.") +
           plot::table_html({"pass", "size", "usual", "on the front", "knee"}, rows);
}

std::string choice_section(const RendererReport& report) {
    if (!report.choice) {
        return "";
    }
    const Choice& c = *report.choice;
    Cells rows;
    std::size_t before = c.front.size();
    for (const BudgetStep& step : c.steps) {
        const Combination& best = c.front[step.combination];
        std::vector<plot::Cell> cells{number_cell(1e3 * step.budget),
                                      number_cell(1e3 * best.seconds), number_cell(best.error)};
        for (std::size_t i = 0; i < c.passes.size(); ++i) {
            const bool is_new =
                before == c.front.size() || c.front[before].options[i] != best.options[i];
            const std::string& name = c.options[i][best.options[i]].name;
            cells.push_back(text_cell(is_new ? name : "."));
        }
        rows.push_back(std::move(cells));
        before = step.combination;
    }
    std::vector<std::string> columns{"budget, ms", "frame, ms", "dE2000 p99"};
    columns.insert(columns.end(), c.passes.begin(), c.passes.end());
    return section(
               "What each step of a budget buys",
               fmt::format("The best combination of all settings within so many milliseconds a "
                           "frame, in steps of {:g} ms; a dot: as in the row above. Times and "
                           "errors of passes are added up: what is not varied is timed with the "
                           "whole frame, and errors that meet come to no more than their sum. "
                           "The chosen one was then rendered and timed as a whole.",
                           1e3 * c.step)) +
           plot::table_html(columns, rows);
}

std::string savings_section(const RendererReport& report) {
    if (report.savings.empty()) {
        return "";
    }
    Cells rows;
    for (const SavingRow& row : report.savings) {
        std::vector<plot::Cell> cells{text_cell(row.name)};
        for (const Costs* const costs : {&row.forced, &row.usual}) {
            cells.push_back(text_cell(std::to_string(costs->passes)));
            cells.push_back(text_cell(interval(costs->time)));
            cells.push_back(number_cell(static_cast<double>(costs->memory) * 1e-6));
            cells.push_back(number_cell(static_cast<double>(costs->bytes) * 1e-6));
        }
        cells.push_back(number_cell(row.largest));
        cells.push_back(text_cell(row.bound == 0 ? "not a bit" : fmt::format("{:.3g}", row.bound)));
        rows.push_back(std::move(cells));
    }
    return section(
               "What leaving out saves",
               fmt::format("From a bare picture to the full scene at {}, each row with all that "
                           "those above it have: everything forced, and as the program draws it "
                           "in a steady frame, where what has not changed rests. Memory is that "
                           "of images and buffers which live within a frame, moved is every "
                           "image that a pass reads or writes, once each. The difference is the "
                           "largest of any channel of the finished picture.",
                           size_text(report.settings.sizes.back()))) +
           plot::table_html({"frame", "forced: passes", "ms", "MB", "MB moved", "usual: passes",
                             "ms", "MB", "MB moved", "difference", "allowed"},
                            rows);
}

std::string growth_section(const RendererReport& report) {
    if (report.growth.empty()) {
        return "";
    }
    plot::Lines lines;
    lines.title = "Time against what there is, of its largest";
    lines.x_label = "share of the largest amount";
    lines.y_label = time_label(report);
    Cells rows;
    for (std::size_t k = 0; k < report.growth.size(); ++k) {
        const Growth& growth = report.growth[k];
        plot::Line line;
        line.name = growth.name;
        line.label = growth.name;
        line.color = k + 1;
        for (const GrowthPoint& point : growth.points) {
            line.points.emplace_back(point.amount / growth.points.back().amount,
                                     milliseconds_of(point.time));
        }
        lines.lines.push_back(std::move(line));
        const GrowthPoint &least = growth.points.front(), &most = growth.points.back();
        rows.push_back({text_cell(growth.name), text_cell(growth.passes),
                        text_cell(fmt::format("{:g} to {:g}", least.amount, most.amount)),
                        text_cell(interval(least.time)), text_cell(interval(most.time)),
                        number_cell(growth.exponent), number_cell(growth.upper_exponent)});
    }
    return section("How costs grow",
                   "Time as a power of the amount, by least squares of logarithms: over all "
                   "amounts, and over the upper half, where what does not grow counts for less. 1: "
                   "twice as much takes twice as long.") +
           "<div class=\"panels\"><div class=\"share\">" + svg(lines) + "</div></div>\n" +
           plot::table_html({"of", "passes", "from, to", "ms of the first", "ms of the last",
                             "exponent", "of the upper half"},
                            rows);
}

std::string glare_section(const RendererReport& report) {
    const GlareModel& glare = report.glare;
    plot::Lines lines;
    lines.title = "Light within a circle about a point";
    lines.x_label = "radius in texels of a picture of 1080 lines";
    lines.y_label = "share of the light";
    lines.y_is_share = true;
    plot::Line model, measured;
    model.name = "bloom 'glare'";
    model.color = 1;
    measured.name = "Spencer 1995";
    measured.color = 2;
    for (const EncircledLight& at : glare.curve) {
        model.points.emplace_back(at.radius, at.model);
        measured.points.emplace_back(at.radius, at.measured);
    }
    model.dots = measured.dots = false;
    lines.lines = {model, measured};
    return section(
               "The model of glare",
               fmt::format("The bloom 'glare' is a sum of four Gaussians that stands for the "
                           "glare within an eye. Beside the point spread function that Spencer, "
                           "Shirley, Zimmerman and Greenberg give (SIGGRAPH 1995, photopic), for "
                           "a picture {:.3g} degrees high: light within a circle differs by at "
                           "most {:.3g} of all, at {:.3g} texels. Of pictures of 1 to "
                           "150 degrees they are nearest for {:.3g} ({:.3g}). This error is apart "
                           "from those "
                           "of the passes, which are held against the sum of Gaussians itself.",
                           glare.field_of_view, glare.largest, glare.at_radius,
                           glare.best_field_of_view, glare.best_largest)) +
           "<div class=\"panels\"><div class=\"share\">" + svg(lines) + "</div></div>\n";
}

std::string left_out_section(const RendererReport& report) {
    if (report.left_out.empty()) {
        return "";
    }
    Cells rows;
    for (const LeftOutStudy& study : report.left_out) {
        rows.push_back({text_cell(std::string(study.study->title)), text_cell(study.reason)});
    }
    return section("What this input has not",
                   "These passes were measured on test pictures alone, or not at all.") +
           plot::table_html({"pass", "why"}, rows);
}

} // namespace

std::vector<std::string> page_sections(const RendererReport& report) {
    return {choice_section(report), knees_section(report), savings_section(report),
            growth_section(report), glare_section(report), left_out_section(report)};
}

} // namespace preview::report
