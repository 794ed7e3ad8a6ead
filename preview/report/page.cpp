#include "preview/report/page.h"

#include "lutlib/plot/page.h"
#include "lutlib/plot/scatter.h"
#include "preview/report/columns.h"
#include "preview/report/page_sections.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview::report {

namespace {

/// What is drawn against time.
struct Plotted {
    const char* name;
    std::optional<double> (*of)(const Row& row);
};
constexpr Plotted plotted[] = {
    {"relative L2 of the finished picture",
     [](const Row& r) { return std::optional(r.picture.relative_l2); }},
    {"relative L2 of the pass alone",
     [](const Row& r) {
         return r.pass ? std::optional(r.pass->relative_l2) : std::optional<double>();
     }},
};

std::string figures_of(const Row& row) {
    return fmt::format("{}: picture L2 {:.3g}, dE2000 p99 {:.3g}, {:.3g} ms ({:.3g} to {:.3g})",
                       row.variant, row.picture.relative_l2, row.picture.delta_e_2000.p99,
                       1e3 * row.time.median, 1e3 * row.time.low, 1e3 * row.time.high);
}

plot::Scatter scatter_of(const RendererReport& report, std::span<const Row> group,
                         std::size_t first, const Plotted& what) {
    plot::Scatter out;
    out.title = fmt::format("{}, {}, {}", group.front().study->title, group.front().input,
                            size_text(group.front().size));
    out.x_label = time_label(report);
    out.y_label = what.name;
    out.y_floor = 1e-7;
    out.series = {{"other"}, {"usual"}};
    for (std::size_t i = 0; i < group.size(); ++i) {
        const Row& row = group[i];
        const std::optional<double> error = what.of(row);
        if (!error) {
            continue;
        }
        const bool is_front = is_on_front(row, first + i) && what.of == plotted[0].of;
        out.marks.push_back({.x = 1e3 * row.time.median,
                             .y = *error,
                             .x_low = 1e3 * row.time.low,
                             .x_high = 1e3 * row.time.high,
                             .series = row.is_usual ? std::size_t{1} : std::size_t{0},
                             .on_front = is_front,
                             .recommended = row.is_usual,
                             .pale = !is_front && !row.is_usual && what.of == plotted[0].of,
                             .label = figures_of(row),
                             .name = row.variant,
                             .row = first + i});
    }
    return out;
}

/// A view a study: the input itself, or else the first test picture, at every size.
std::vector<plot::View> views_of(const RendererReport& report) {
    std::vector<plot::View> out;
    std::size_t first = 0;
    const Study* last = nullptr;
    std::string input;
    for (const std::span<const Row> group : groups_of(report)) {
        const Row& any = group.front();
        if (any.study != last) {
            last = any.study;
            input = any.input;
            out.push_back({std::string(any.study->title), {}});
        }
        if (any.input == input) {
            for (const Plotted& what : plotted) {
                const plot::Scatter scatter = scatter_of(report, group, first, what);
                // A pass that is the finished picture has no error of its own.
                if (!scatter.marks.empty() &&
                    (&what == std::begin(plotted) || any.study->looked.result != nullptr)) {
                    out.back().plots.push_back(svg(scatter));
                }
            }
        }
        first += group.size();
    }
    return out;
}

plot::Table table_of(const RendererReport& report) {
    plot::Table out;
    out.columns = {"pass", "input", "size", "variant", "usual"};
    out.naming = {0, 1, 2, 3};
    out.filters = {0, 1, 2};
    for (const RowMetric& metric : row_metrics()) {
        if (metric.is_tabled) {
            out.columns.emplace_back(metric.name);
        }
    }
    out.columns.insert(out.columns.end(), {"95 % of it", "dominated by"});
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const Row& row = report.rows[i];
        plot::Row cells{{plot::text_cell(std::string(row.study->title)), plot::text_cell(row.input),
                         plot::text_cell(size_text(row.size)), plot::text_cell(row.variant),
                         plot::text_cell(row.is_usual ? "usual" : "")},
                        !is_on_front(row, i),
                        row.is_usual};
        for (const RowMetric& metric : row_metrics()) {
            if (metric.is_tabled) {
                const std::optional<double> value = metric.of(row);
                cells.cells.push_back(value ? plot::number_cell(*value) : plot::text_cell(""));
            }
        }
        cells.cells.push_back(
            {fmt::format("{:.3g}..{:.3g}", 1e3 * row.time.low, 1e3 * row.time.high), row.time.low,
             true});
        cells.cells.push_back(plot::text_cell(
            cells.dominated ? report.rows[row.dominated_by].variant : "nothing: on the front"));
        out.rows.push_back(std::move(cells));
    }
    return out;
}

std::vector<std::string> method(const RendererReport& report) {
    std::vector<std::string> out{
        fmt::format(
            "Device: {}. {}", report.device,
            report.is_cpu
                ? "It is a software device: every time on this page is that of a CPU, which "
                  "says nothing of a GPU's, and no GPU's time stands beside it."
                : "Times are its own timestamps about the passes named."),
        fmt::format("Times: medians of {} frames after a warm-up, the variants of a pass in turn, "
                    "each frame behind an untimed one of its own, with {}. Everything is forced, "
                    "so that nothing rests.",
                    report.settings.rounds,
                    report.settings.rounds < 6 ? "the least and the largest"
                                               : "the interval that holds the median with 95 %"),
        "Errors: the finished picture is compared in floats, before it is rounded to 8 bits, read "
        "as "
        "sRGB; dE2000 and dE-ITP at each pixel. Relative L2 is the root of the squares of all "
        "differences over that of what should be there. Drift: how much more light the pass gives "
        "in "
        "all, of the channel that is worst. Of an impulse: asymmetry is what differs within rings "
        "about it, centroid how far the middle of the light has moved, in texels. Unrest, as a "
        "share "
        "of the light's root mean square: how much a texel of the scene changes while a camera "
        "pans "
        "over the sun by a texel a frame, over six frames; of a scene how much the error of a "
        "texel "
        "of the picture changes while the camera turns by half a texel a frame, over four.",
        fmt::format("Look of the lookups: {}.", report.look)};
    for (const Study* const study : studies()) {
        out.push_back(
            fmt::format("{}: {} Held against: {}", study->title, study->help, study->reference));
    }
    out.emplace_back("Dominated: another variant of the pass on the same input is no slower and no "
                     "farther in the finished picture's L2, and better in one.");
    return out;
}

} // namespace

std::string to_html(const RendererReport& report) {
    plot::Page page;
    page.title = "Error against time of the renderer: " + report.input;
    page.summary = recommendation_text(report);
    page.paragraphs = method(report);
    page.views = views_of(report);
    page.sections = page_sections(report);
    page.table = table_of(report);
    return html(page);
}

} // namespace preview::report
