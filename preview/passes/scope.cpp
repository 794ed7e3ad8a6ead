#include "preview/passes/scope.h"

#include <algorithm>
#include <string>

namespace preview {

namespace {

struct DrawPush {
    ScopePlot plot;
    std::uint32_t columns, width, height, logarithmic;
};

BufferHandle count_columns(Graph& graph, ImageHandle picture, const Scope& scope, ColumnRange range,
                           std::uint32_t columns, BufferHandle counts) {
    Pass pass =
        graph.compute(std::string("count ") + std::string(scope.name), "scope_waveform.comp");
    pass.read(picture);
    counts = pass.write(counts);
    pass.constants({scope.planes});
    pass.push(std::array{range.first, range.count, columns});
    pass.dispatch(columns);
    return counts;
}

BufferHandle count_privately(Graph& graph, ImageHandle picture, const Scope& scope,
                             ColumnRange range, BufferHandle counts) {
    const std::string name(scope.name);
    counts = graph.fill("clear " + name, counts, 0);
    Pass pass =
        graph.compute("count " + name, scope.bins == ScopeBins::chroma ? "scope_vectorscope.comp"
                                                                       : "scope_histogram.comp");
    pass.read(picture);
    counts = pass.modify(counts);
    pass.push(std::array{range.first, range.count});
    pass.dispatch(counting_groups(std::uint64_t{range.count} * graph.image_desc(picture).height));
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

std::uint32_t scope_columns(const Scope& scope, ColumnRange range, Size size) {
    const ScopePlot plot = scope_plot(scope, size.width, size.height);
    return std::min(static_cast<std::uint32_t>(plot.width), range.count);
}

ScopePicture add_scope(Graph& graph, ImageHandle picture, const Scope& scope, ColumnRange range,
                       Size size, bool logarithmic) {
    const std::string name(scope.name);
    const std::uint32_t columns = scope_columns(scope, range, size);
    const BufferHandle counts = graph.buffer("counts of " + name, 4 * scope_counts(scope, columns));
    ScopePicture out;
    out.counts = scope.bins == ScopeBins::columns
                     ? count_columns(graph, picture, scope, range, columns, counts)
                     : count_privately(graph, picture, scope, range, counts);

    Pass pass = graph.compute("draw " + name, drawing_shader(scope.bins));
    pass.storage(out.counts);
    out.picture = pass.write(graph.image(name, {Format::rgba8, size.width, size.height}));
    if (scope.bins == ScopeBins::columns) {
        pass.constants({scope.planes, scope.is_overlaid ? 1U : 0U});
    }
    pass.push(DrawPush{scope_plot(scope, size.width, size.height), columns, range.count,
                       graph.image_desc(picture).height, logarithmic});
    pass.dispatch_over(size.width, size.height);
    return out;
}

} // namespace preview
