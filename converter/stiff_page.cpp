#include "converter/stiff_page.h"

#include "converter/survey_columns.h"
#include "lutlib/plot/lines.h"
#include "lutlib/plot/page.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace converter {
namespace {

using lutlib::StiffAxis;
using lutlib::StiffCurve;
using lutlib::StiffPoint;
using lutlib::StiffSurvey;

const char* axis_text(StiffAxis axis) {
    return axis == StiffAxis::channel ? "each channel" : "mixed";
}

std::string slope_text(const lutlib::Slope& slope) {
    return slope.points < 2 ? std::string("-")
           : std::isfinite(slope.interval)
               ? fmt::format("{:.2f} ± {:.2f}", slope.value, slope.interval)
               : fmt::format("{:.2f}", slope.value);
}

// The methods that a view of the page compares, by their names.
struct Comparison {
    const char* name;
    std::vector<std::string_view> methods;
};
const std::vector<Comparison>& comparisons() {
    static const std::vector<Comparison> out{
        {"lookups", {"nearest", "trilinear", "tetrahedral", "tricubic"}},
        {"shaper and fit", {"tetrahedral", "shaper", "fitted"}},
        {"bits", {"8", "10", "16", "tetrahedral"}},
    };
    return out;
}

bool is_compared(const Comparison& c, const StiffCurve& curve) {
    return std::find(c.methods.begin(), c.methods.end(), curve.method->name) != c.methods.end();
}

// A function's largest errors against the width of a cell, by the methods of one view.
std::string plot_of(const StiffSurvey& survey, const Comparison& comparison, std::size_t first) {
    const StiffCurve& about = survey.curves[first];
    plot::Lines out;
    out.title = fmt::format("{}, {}", about.profile->name, axis_text(about.axis));
    out.x_label = "width of a cell";
    out.y_label = "largest error, worst phase";
    out.y_floor = 1e-7;
    out.height = 380;
    plot::Line bound{"bound of means, before measuring", "", 0, true, false, {}};
    std::size_t color = 1;
    for (std::size_t i = first; i < first + lutlib::stiff_methods().size(); ++i) {
        const StiffCurve& curve = survey.curves[i];
        if (!is_compared(comparison, curve)) {
            continue;
        }
        plot::Line line{fmt::format("{}: order {}", curve.method->label, slope_text(curve.largest)),
                        "",
                        color++,
                        false,
                        true,
                        {}};
        for (const StiffPoint& point : curve.points) {
            const double cell = 1.0 / (point.size - 1);
            line.points.emplace_back(cell, point.worst.max);
            if (curve.method->name == "tetrahedral" && point.bound > 0) {
                bound.points.emplace_back(cell, point.bound);
            }
        }
        out.lines.push_back(std::move(line));
    }
    if (!bound.points.empty()) {
        out.lines.push_back(std::move(bound));
    }
    return svg(out);
}

std::vector<std::string> method_text(const StiffSurvey& survey) {
    const lutlib::StiffSettings& s = survey.settings;
    return {
        fmt::format(
            "Each function is exact at every colour, and lattices sample it at their nodes. Its "
            "feature stands at {} places within a cell, one after the other; a figure is the mean "
            "over these phases or the worst of them. p99 and mean are over {} colours spread "
            "evenly over 0..1, the largest error over those and as many within a cell of the "
            "feature. An error is the largest channel difference; outputs are about 0..1.",
            s.phases, s.colors),
        "Each channel: every output is the curve of its own channel. Mixed: of 0.6, 0.3 and 0.1 "
        "of the channels, turned for the next output, so that the feature crosses cells.",
        "Order: the exponent p of error = c h^p over widths h of a cell, by least squares of the "
        "logarithms, with its interval of 95 %. Theory, of linear interpolation: 2 where the "
        "second derivative is bounded, 1 at a kink, the exponent of a root or power, 0 at a step. "
        "No order is expected of features that are narrower than usual cells.",
        "Bound: of any interpolation that means a cell's nodes and is exact for linear functions, "
        "the least of h^2/8 max|g''|, h/2 max|g'| and the largest change of the curve over h; of "
        "the nearest node, the largest change over h/2. No measurement enters it.",
        fmt::format("Fitted and tricubic: at {} phases, up to {} and {} nodes. Behind a shaper: "
                    "nodes are spaced as sRGB spaces its codes. Lookups are read in double from "
                    "nodes as they are stored.",
                    std::min(s.whole_phases, s.phases), s.largest_fitted, s.largest_tricubic),
    };
}

std::string summary(const StiffSurvey& survey) {
    std::string out = "Orders of convergence of the largest error, tetrahedral, mixed channels";
    const char* separator = ": ";
    for (const StiffCurve& curve : survey.curves) {
        if (curve.method->name == "tetrahedral" && curve.axis == StiffAxis::mixed &&
            curve.profile->order >= 0) {
            out += fmt::format("{}{} {} (theory {:.2g})", separator, curve.profile->name,
                               slope_text(curve.largest), curve.profile->order);
            separator = "; ";
        }
    }
    return out + ".";
}

plot::Table stiff_table(const StiffSurvey& survey) {
    plot::Table out;
    out.columns = {"function",   "what it is",          "of",    "method",     "theory",
                   "order",      "order of the mean",   "nodes", "p99, worst", "mean, worst",
                   "max, worst", "max, mean of phases", "bound"};
    out.naming = {0, 2, 3, 7};
    out.filters = {0, 2, 3, 7};
    for (const StiffCurve& curve : survey.curves) {
        for (const StiffPoint& point : curve.points) {
            const double theory = curve.profile->order;
            plot::Row row;
            row.cells = {
                plot::text_cell(std::string(curve.profile->name)),
                plot::text_cell(std::string(curve.profile->help)),
                plot::text_cell(axis_text(curve.axis)),
                plot::text_cell(std::string(curve.method->label)),
                {theory >= 0 ? fmt::format("{:.2g}", theory) : "-", theory, true},
                {slope_text(curve.largest), curve.largest.value, true},
                {slope_text(curve.mean), curve.mean.value, true},
                {std::to_string(point.size), static_cast<double>(point.size), true},
                plot::number_cell(point.worst.p99),
                plot::number_cell(point.worst.mean),
                plot::number_cell(point.worst.max),
                plot::number_cell(point.average.max),
                {point.bound > 0 ? fmt::format("{:.3g}", point.bound) : "-", point.bound, true}};
            out.rows.push_back(std::move(row));
        }
    }
    return out;
}

nlohmann::ordered_json slope_json(const lutlib::Slope& slope) {
    nlohmann::ordered_json out{{"value", slope.value}, {"points", slope.points}};
    out["interval_95"] = std::isfinite(slope.interval) ? nlohmann::ordered_json(slope.interval)
                                                       : nlohmann::ordered_json();
    return out;
}

nlohmann::ordered_json stiff_figures_json(const lutlib::StiffFigures& f) {
    return {{"p99", f.p99}, {"mean", f.mean}, {"max", f.max}};
}

} // namespace

std::string stiff_html(const StiffSurvey& survey) {
    plot::Page page;
    page.title = "Stiff and extreme looks: error against the width of a cell";
    page.summary = summary(survey);
    page.paragraphs = method_text(survey);
    for (const Comparison& comparison : comparisons()) {
        plot::View view{comparison.name, {}};
        for (std::size_t i = 0; i < survey.curves.size(); i += lutlib::stiff_methods().size()) {
            view.plots.push_back(plot_of(survey, comparison, i));
        }
        page.views.push_back(std::move(view));
    }
    page.table = stiff_table(survey);
    return html(page);
}

nlohmann::ordered_json stiff_json(const StiffSurvey& survey) {
    nlohmann::ordered_json out{{"phases", survey.settings.phases},
                               {"colours", survey.settings.colors}};
    for (const StiffCurve& curve : survey.curves) {
        nlohmann::ordered_json one{{"function", curve.profile->name},
                                   {"of", axis_text(curve.axis)},
                                   {"method", curve.method->name},
                                   {"order", slope_json(curve.largest)},
                                   {"order_of_mean", slope_json(curve.mean)}};
        one["theory"] = curve.profile->order >= 0 ? nlohmann::ordered_json(curve.profile->order)
                                                  : nlohmann::ordered_json();
        for (const StiffPoint& point : curve.points) {
            nlohmann::ordered_json at{{"size", point.size},
                                      {"worst_phase", stiff_figures_json(point.worst)},
                                      {"mean_of_phases", stiff_figures_json(point.average)}};
            at["bound"] =
                point.bound > 0 ? nlohmann::ordered_json(point.bound) : nlohmann::ordered_json();
            one["points"].push_back(std::move(at));
        }
        out["curves"].push_back(std::move(one));
    }
    return out;
}

std::string stiff_csv_head() {
    return csv_line({"function", "of", "method", "order", "size", "p99_worst", "mean_worst",
                     "max_worst", "p99_mean", "mean_mean", "max_mean", "bound"});
}

std::string stiff_csv(const StiffSurvey& survey) {
    std::string out = stiff_csv_head();
    for (const StiffCurve& curve : survey.curves) {
        for (const StiffPoint& point : curve.points) {
            std::vector<std::string> words{std::string(curve.profile->name), axis_text(curve.axis),
                                           std::string(curve.method->name),
                                           fmt::format("{:.6g}", curve.largest.value),
                                           std::to_string(point.size)};
            for (const lutlib::StiffFigures* f : {&point.worst, &point.average}) {
                for (const double value : {f->p99, f->mean, f->max}) {
                    words.push_back(fmt::format("{:.9g}", value));
                }
            }
            words.push_back(fmt::format("{:.9g}", point.bound));
            out += csv_line(words);
        }
    }
    return out;
}

} // namespace converter
