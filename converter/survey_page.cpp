#include "converter/survey_page.h"

#include "converter/survey_panels.h"
#include "converter/survey_sections.h"
#include "lutlib/plot/page.h"
#include "lutlib/plot/scatter.h"
#include "lutlib/survey/pareto.h"

#include <fmt/core.h>

#include <array>
#include <functional>

namespace converter {
namespace {

using lutlib::Survey;
using lutlib::SurveyRow;

// Of survey_metrics; the rest stands in the JSON and the CSV.
constexpr std::array<std::size_t, 4> plotted{0, 1, 2, 3};
constexpr std::array<std::size_t, 5> tabled{0, 1, 2, 3, 6};

// What a cost of each row is; NaN: the row is not in the plot.
using CostOf = std::function<double(std::size_t row)>;

plot::Scatter scatter(const Survey& survey, const SurveyMetric& metric, const std::string& label,
                      const CostOf& cost) {
    plot::Scatter out;
    out.title = fmt::format("{} against {}", metric.name, label);
    out.x_label = label;
    out.y_label = metric.name;
    out.series = lookup_series();
    out.circle_name = "point-sampled";
    out.diamond_name = "fitted";
    std::vector<std::array<double, 2>> points;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        if (cost(i) > 0) {
            points.push_back({cost(i), metric.of(survey.rows[i].error)});
            rows.push_back(i);
        }
    }
    const std::vector<std::size_t> by = lutlib::dominators<2>(points);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const SurveyRow& row = survey.rows[rows[k]];
        const bool front = by[k] == lutlib::not_dominated;
        const bool recommended = rows[k] == survey.recommendation.row;
        out.marks.push_back({.x = points[k][0],
                             .y = points[k][1],
                             .series = lookup_index(*row.what.lookup),
                             .diamond = row.what.fitted,
                             .on_front = front,
                             .recommended = recommended,
                             .pale = !front && !recommended,
                             .name = short_name(row.what),
                             .row = rows[k]});
    }
    return out;
}

std::string time_plot(const Survey& survey, const SurveyMetric& metric) {
    plot::Scatter out = scatter(survey, metric, survey_costs[0].label,
                                [&](std::size_t i) { return survey_costs[0].of(survey.rows[i]); });
    for (plot::Mark& mark : out.marks) {
        mark.x_low = 1e9 * survey.rows[mark.row].pixel.low;
        mark.x_high = 1e9 * survey.rows[mark.row].pixel.high;
    }
    return svg(out);
}

std::string bytes_plot(const Survey& survey, const SurveyMetric& metric) {
    return svg(scatter(survey, metric, survey_costs[1].label,
                       [&](std::size_t i) { return survey_costs[1].of(survey.rows[i]); }));
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
        fmt::format("Errors: against the look evaluated exactly in double; p99 and mean over {} "
                    "colours spread evenly over the domain. abs is the largest channel difference "
                    "in code values. Maxima: over the grid of all nodes of the look and of the "
                    "lattice, the middles between them, and uphill from the worst, further for "
                    "what is recommended{}.",
                    survey.colors,
                    survey.largest_seen ? "; since operators may bend anywhere and large grids are "
                                          "thinned, they are the largest seen"
                                        : ""),
        fmt::format(
            "Time: what lutconv apply does, on one of the cores and with its vectors, over {} "
            "pixels whose colours are spread evenly in no order, which is the hardest for caches; "
            "in each of {} rounds every combination once, warmed; the median, the interval that "
            "holds it with 95 %, and in JSON and CSV the best. Pixels do not wait for each other, "
            "so that more cores take so much less time as long as memory keeps up. It depends on "
            "size, 1D table, storage and lookup, not on the values, and was measured once for each "
            "of these. Hardware trilinear is what texture units do; its time here is that of "
            "emulating it on a CPU.",
            s.pixels, s.rounds),
        "Bytes: of the nodes as stored, and 12 for each entry of the 1D table where there is one. "
        "Bake time: one run, all cores.",
        "Dominated: another combination is no worse in largest dE2000, time and bytes, and better "
        "in one. The dashed line joins what no other beats in the plot's own two measures. A mark "
        "that would hide another stands beside it."};
    out.push_back(range_text(survey));
    for (const std::string& note : survey.notes) {
        out.push_back("Note: " + note + ".");
    }
    return out;
}

plot::Table survey_table(const Survey& survey) {
    plot::Table out;
    out.columns = {"nodes", "shaper", "storage", "lookup", "filling"};
    out.naming = {0, 1, 2, 3, 4};
    out.filters = {0, 1, 2, 3};
    for (const std::size_t i : tabled) {
        out.columns.emplace_back(survey_metrics[i].name);
    }
    for (const char* name :
         {"kB", "ns a pixel", "95 % of it", "ms 1080p", "ms 4K", "bake ms", "dominated by"}) {
        out.columns.emplace_back(name);
    }
    const std::vector<std::size_t> by = dominators_of(survey);
    for (std::size_t i = 0; i < survey.rows.size(); ++i) {
        const SurveyRow& row = survey.rows[i];
        plot::Row cells{{{std::to_string(row.what.size), static_cast<double>(row.what.size), true},
                         plot::text_cell(std::string(row.what.shaper->name)),
                         plot::text_cell(std::string(row.what.storage->label)),
                         plot::text_cell(lookup_series()[lookup_index(*row.what.lookup)].name),
                         plot::text_cell(row.what.fitted ? "fitted" : "sampled")},
                        by[i] != lutlib::not_dominated,
                        i == survey.recommendation.row};
        for (const std::size_t k : tabled) {
            cells.cells.push_back(plot::number_cell(survey_metrics[k].of(row.error)));
        }
        const auto bytes = static_cast<double>(row.bytes);
        cells.cells.push_back({fmt::format("{:.1f}", bytes / 1000), bytes, true});
        cells.cells.push_back(plot::number_cell(survey_costs[0].of(row)));
        cells.cells.push_back(
            {fmt::format("{:.3g}..{:.3g}", 1e9 * row.pixel.low, 1e9 * row.pixel.high),
             row.pixel.low, true});
        for (const Raster& raster : rasters) {
            cells.cells.push_back(plot::number_cell(milliseconds(row, raster)));
        }
        cells.cells.push_back(plot::number_cell(1e3 * row.bake_seconds));
        cells.cells.push_back(plot::text_cell(cells.dominated ? short_name(survey.rows[by[i]].what)
                                                              : "nothing: on the front"));
        out.rows.push_back(std::move(cells));
    }
    return out;
}

std::string gpu_section(const Survey& survey, const GpuTimes& times) {
    std::vector<std::vector<plot::Cell>> rows;
    for (const GpuTime& time : times.rows) {
        std::vector<plot::Cell> cells{plot::text_cell(time.lookup), plot::text_cell(time.formats)};
        for (const Raster& raster : rasters) {
            cells.push_back(plot::number_cell(times.milliseconds(time, raster)));
        }
        cells.push_back(plot::number_cell(time.ratio_to_copy));
        if (time.row) {
            const SurveyRow& row = survey.rows[*time.row];
            cells.push_back(plot::text_cell(short_name(row.what)));
            cells.push_back(plot::number_cell(row.error.delta_e_2000.p99));
            cells.push_back(plot::number_cell(row.error.delta_e_2000.max));
        } else {
            cells.insert(cells.end(), 3, plot::text_cell(""));
        }
        rows.push_back(std::move(cells));
    }
    return "<h2>On a GPU: " + plot::escaped(times.device) +
           "</h2>\n<p>Times of preview_bench, scaled by pixels. Errors are those of the "
           "combination "
           "that the lookup reads, where it is among these.</p>\n" +
           plot::table_html({"lookup", "formats", "ms 1080p", "ms 4K", "x copy", "combination",
                             "dE2000 p99", "dE2000 max"},
                            rows);
}

// Errors against a GPU's times, of the combinations that it has timed.
std::string gpu_plot(const Survey& survey, const SurveyMetric& metric, const GpuTimes& times) {
    return svg(
        scatter(survey, metric, "milliseconds of 4K on " + times.device, [&](std::size_t row) {
            for (const GpuTime& time : times.rows) {
                if (time.row == row) {
                    return times.milliseconds(time, rasters.back());
                }
            }
            return 0.0;
        }));
}

} // namespace

std::string survey_html(const Survey& survey, const std::string& look,
                        const std::optional<GpuTimes>& gpu) {
    plot::Page page;
    page.title = "Error against run time: " + look;
    page.summary = recommendation_text(survey);
    page.paragraphs = method(survey);
    for (const std::size_t i : plotted) {
        const SurveyMetric& metric = survey_metrics[i];
        plot::View view{metric.name, {time_plot(survey, metric), bytes_plot(survey, metric)}};
        if (gpu) {
            view.plots.push_back(gpu_plot(survey, metric, *gpu));
        }
        page.views.push_back(std::move(view));
    }
    page.panels = survey_panels(survey);
    if (gpu) {
        page.sections.push_back(gpu_section(survey, *gpu));
    }
    for (std::string& section : strain_sections(survey.strain)) {
        page.sections.push_back(std::move(section));
    }
    page.table = survey_table(survey);
    return html(page);
}

} // namespace converter
