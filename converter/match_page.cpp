#include "converter/match_page.h"

#include "converter/report.h"
#include "converter/result.h"
#include "lutlib/plot/heat_map.h"
#include "lutlib/plot/page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace converter {
namespace {

constexpr int planes = 9;             // of the cube, evenly from blue 0 to blue 1
constexpr std::size_t most_maps = 24; // of pictures

// Bright where pixels say much, dark where they say nothing near.
char coverage_letter(double support, int steps) {
    constexpr double little = 1.0 / 16, much = 64, dim = 0.45, fades_by = 0.06;
    if (steps == 0) {
        const double share = std::log(std::clamp(support, little, much) / little);
        return plot::share_letter(0.6 + 0.4 * share / std::log(much / little));
    }
    return plot::share_letter(std::max(0.0, dim - fades_by * std::min(steps, 100)));
}

std::string plane_of(const Matched& matched, int b) {
    const int size = matched.coverage.size;
    plot::HeatMap out{.id = fmt::format("plane-{}", b),
                      .title = fmt::format("blue {:.2f}", static_cast<double>(b) / (size - 1)),
                      .x_label = "red",
                      .y_label = "green",
                      .columns = size,
                      .rows = size,
                      .levels = {}};
    for (int g = 0; g < size; ++g) {
        for (int r = 0; r < size; ++r) {
            const std::size_t k = matched.match.cube.index(r, g, b);
            out.levels += coverage_letter(matched.match.support[k], matched.coverage.steps[k]);
        }
    }
    return svg(out);
}

std::string map_of(const MatchedPair& pair, std::size_t number) {
    plot::HeatMap out{.id = fmt::format("pair-{}", number),
                      .title = input_text(pair.paths.after),
                      .x_label = "x",
                      .y_label = "y",
                      .columns = pair.places.width,
                      .rows = pair.places.height,
                      .levels = {}};
    for (int y = pair.places.height - 1; y >= 0; --y) {
        for (int x = 0; x < pair.places.width; ++x) {
            out.levels +=
                plot::error_letter(pair.map[static_cast<std::size_t>(y * pair.places.width + x)]);
        }
    }
    return svg(out);
}

plot::Table patches_table(const Matched& matched) {
    plot::Table out;
    out.columns = {"patch", "before", "after", "dE2000", "dE2000 from the others"};
    out.naming = {0};
    for (const MatchedPatch& patch : matched.patches) {
        plot::Row row;
        row.cells = {plot::text_cell(patch.name), plot::text_cell(color_text(patch.before)),
                     plot::text_cell(color_text(patch.after)), plot::number_cell(patch.off),
                     plot::number_cell(patch.off_left_out)};
        out.rows.push_back(std::move(row));
    }
    return out;
}

plot::Table pairs_table(const Matched& matched) {
    plot::Table out;
    out.columns = {"before", "after", "shift", "mean", "p99", "largest", "edits"};
    out.naming = {1};
    for (const MatchedPair& pair : matched.pairs) {
        std::string edits;
        for (const std::string& edit : pair.edits) {
            edits += (edits.empty() ? "" : "; ") + one_line(edit);
        }
        plot::Row row;
        row.cells = {plot::text_cell(input_text(pair.paths.before)),
                     plot::text_cell(input_text(pair.paths.after)),
                     plot::text_cell(fmt::format("{}, {}", pair.shift.by.x, pair.shift.by.y)),
                     plot::number_cell(pair.delta_e_2000.mean),
                     plot::number_cell(pair.delta_e_2000.p99),
                     plot::number_cell(pair.delta_e_2000.max),
                     plot::text_cell(edits.empty() ? "none" : edits)};
        out.rows.push_back(std::move(row));
    }
    return out;
}

std::string corners_section(const lutlib::Coverage& coverage) {
    std::vector<std::vector<plot::Cell>> rows;
    for (const lutlib::CornerCoverage& corner : coverage.corners) {
        rows.push_back(
            {plot::text_cell(std::string(corner.name)), plot::number_cell(100 * corner.supported)});
    }
    return "<h2>The cube by its corners</h2>\n<p>Of the nodes in the eighth around each corner, "
           "those of which a pixel says something.</p>\n" +
           plot::table_html({"corner", "% of its nodes"}, rows);
}

} // namespace

std::string match_html(const Matched& matched, const std::string& look) {
    plot::Page page;
    page.title = "A look from pictures: " + output_text(look);
    page.summary = fmt::format(
        "dE2000 of the look from what was graded: mean {:.2f}, p99 {:.2f}{}; {:.1f} % of the "
        "cube's nodes are supported by pixels, the others follow them.",
        matched.held_out ? matched.held_out->mean : matched.own.mean,
        matched.held_out ? matched.held_out->p99 : matched.own.p99,
        matched.held_out ? " where it was not learnt" : "", 100 * matched.coverage.supported);
    page.paragraphs = {
        "Like colours of the pictures are meant, without pixels that stray. A base of a curve a "
        "channel, a matrix and chroma by luminance is fitted to them, and a lattice to what it "
        "leaves over. Where no pixel is, the lattice fades and the base goes on.",
        "Held out are tiles of 16x16 pixels, every eighth: a look learnt from the others is "
        "measured there. The look that was written is learnt from all.",
        "Coverage: bright nodes have pixels about them, grey to dark ones are so many nodes away "
        "from one that has."};
    plot::View coverage{"coverage", {}};
    const int size = matched.coverage.size;
    for (int i = 0; i < std::min(planes, size); ++i) {
        coverage.plots.push_back(plane_of(matched, i * (size - 1) / (std::min(planes, size) - 1)));
    }
    page.views.push_back(std::move(coverage));
    plot::View misses{"where it misses", {}};
    for (std::size_t i = 0; i < std::min(most_maps, matched.pairs.size()); ++i) {
        misses.plots.push_back(map_of(matched.pairs[i], i));
    }
    if (!misses.plots.empty()) {
        page.views.push_back(std::move(misses));
        page.sections.push_back(plot::heat_legend("dE2000 of a place of the picture"));
    }
    page.sections.push_back(corners_section(matched.coverage));
    page.table = matched.patches.empty() ? pairs_table(matched) : patches_table(matched);
    return html(page);
}

} // namespace converter
