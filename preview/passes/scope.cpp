#include "preview/passes/scope.h"

#include "preview/passes/glyphs.h"

#include <algorithm>
#include <bit>
#include <span>
#include <string>
#include <vector>

namespace preview {

namespace {

struct DrawPush {
    ScopePlot plot;
    std::uint32_t columns, width, height, logarithmic, labels, lines, marks;
    float gain;
};

using LabelRow = std::array<std::int32_t, 4>;

/// As shaders/common/scope_draw.glsl reads them, the lines after the labels; at least one, for a
/// binding must have bytes.
std::vector<LabelRow> label_rows(std::span<const ScopeLabel> labels,
                                 std::span<const LevelFigure> lines) {
    constexpr std::size_t glyph_bits = 6, most_glyphs = 5;
    std::vector<LabelRow> rows;
    for (const ScopeLabel& label : labels) {
        std::uint32_t glyphs = 0;
        const std::size_t count = std::min(label.text.size(), most_glyphs);
        for (std::size_t i = 0; i < count; ++i) {
            glyphs |= glyph_of(label.text[i]) << glyph_bits * i;
        }
        rows.push_back({label.x, label.y, static_cast<std::int32_t>(glyphs),
                        static_cast<std::int32_t>(count)});
    }
    for (const LevelFigure& line : lines) {
        const auto code = static_cast<float>((scope_levels - 1) * line.at);
        rows.push_back({std::bit_cast<std::int32_t>(code), 0, 0, 0});
    }
    rows.resize(std::max<std::size_t>(rows.size(), 1));
    return rows;
}

/// Of shaders/common/scope_area.glsl.
struct CountPush {
    std::uint32_t x, y, width, height, total, stride, columns, unused;
    WipeShape border;
    float reach;
};

CountPush push_of(const ScopeArea& area, std::uint32_t columns) {
    return {area.x,      area.y,  area.width, area.height, area.columns(),
            area.stride, columns, 0,          area.border, area.reach};
}

BufferHandle count_columns(Graph& graph, ImageHandle picture, const Scope& scope,
                           const ScopeArea& area, std::uint32_t columns, BufferHandle counts) {
    Pass pass =
        graph.compute(std::string("count ") + std::string(scope.name), "scope_waveform.comp");
    pass.read(picture);
    counts = pass.write(counts);
    pass.constants({static_cast<std::uint32_t>(area.part), scope.planes});
    pass.push(push_of(area, columns));
    pass.dispatch(columns);
    return counts;
}

BufferHandle count_privately(Graph& graph, ImageHandle picture, const Scope& scope,
                             const ScopeArea& area, BufferHandle counts) {
    const std::string name(scope.name);
    counts = graph.fill("clear " + name, counts, 0);
    Pass pass =
        graph.compute("count " + name, scope.bins == ScopeBins::chroma ? "scope_vectorscope.comp"
                                                                       : "scope_histogram.comp");
    pass.read(picture);
    counts = pass.modify(counts);
    pass.constants({static_cast<std::uint32_t>(area.part)});
    pass.push(push_of(area, 0));
    pass.dispatch(counting_groups(std::uint64_t{area.columns()} * area.height));
    return counts;
}

const char* drawing_shader(ScopeBins bins) {
    switch (bins) {
    case ScopeBins::columns:
        return "scope_draw_waveform.comp";
    case ScopeBins::chroma:
        return "scope_draw_vectorscope.comp";
    case ScopeBins::levels:
        break;
    }
    return "scope_draw_histogram.comp";
}

} // namespace

std::uint32_t scope_columns(const Scope& scope, const ScopeArea& area,
                            const ScopeDrawing& drawing) {
    const ScopePlot plot = scope_plot(scope, drawing.size.width, drawing.size.height,
                                      drawing.room_for, level_figures(drawing.levels));
    return std::min(static_cast<std::uint32_t>(plot.width), area.columns());
}

ScopeCounts count_scope(Graph& graph, ImageHandle picture, const Scope& scope,
                        const ScopeArea& area, const ScopeDrawing& drawing) {
    ScopeCounts out{{}, scope_columns(scope, area, drawing), area.columns(), area.height};
    out.counts = graph.buffer("counts of " + std::string(scope.name),
                              sizeof(std::uint32_t) * scope_counts(scope, out.columns));
    out.counts = scope.bins == ScopeBins::columns
                     ? count_columns(graph, picture, scope, area, out.columns, out.counts)
                     : count_privately(graph, picture, scope, area, out.counts);
    return out;
}

ImageHandle draw_scope(Graph& graph, const Scope& scope, const ScopeCounts& counted,
                       const ScopeDrawing& drawing) {
    const std::string name(scope.name);
    const Size size = drawing.size;
    Pass pass = graph.compute("draw " + name, drawing_shader(scope.bins));
    pass.storage(counted.counts);
    const ImageHandle picture =
        pass.write(graph.image(name, {Format::rgba8, size.width, size.height}));
    if (scope.bins == ScopeBins::columns) {
        pass.constants({scope.planes, scope.is_overlaid ? 1U : 0U});
    }
    const std::vector<LevelFigure> lines = level_figures(drawing.levels);
    const ScopePlot plot = scope_plot(scope, size.width, size.height, drawing.room_for, lines);
    std::vector<ScopeLabel> labels;
    if (!drawing.room_for) {
        labels = scope_labels(scope, plot, dotted_figures(plot), lines);
    }
    const std::vector<LabelRow> rows = label_rows(labels, lines);
    pass.storage(graph.data("figures of " + name, std::as_bytes(std::span<const LabelRow>(rows))));
    pass.push(DrawPush{plot, counted.columns, counted.width, counted.height, drawing.logarithmic,
                       static_cast<std::uint32_t>(labels.size()),
                       static_cast<std::uint32_t>(lines.size()), !drawing.levels.converts(),
                       drawing.gain});
    pass.dispatch_over(size.width, size.height);
    return picture;
}

ScopePicture add_scope(Graph& graph, ImageHandle picture, const Scope& scope, const ScopeArea& area,
                       const ScopeDrawing& drawing) {
    const ScopeCounts counted = count_scope(graph, picture, scope, area, drawing);
    return {counted.counts, draw_scope(graph, scope, counted, drawing)};
}

} // namespace preview
