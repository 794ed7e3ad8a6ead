#include "preview/passes/axes.h"

#include <algorithm>

namespace preview {

Handle add_axes(Graph& graph, Handle picture, const BloomLayers& bloom,
                const FinishSettings& settings, const lutlib::Encoding& encoding) {
    constexpr std::uint32_t group_texels = 8192, most_groups = 528;
    const Size size = size_of(graph, picture);
    Handle counts =
        graph.buffer("axis counts", sizeof(std::uint32_t) * axis_bins * counted_axes.size());
    counts = graph.fill("clear axis counts", counts, 0);
    Pass pass = graph.compute("count along axes", "axes.comp");
    bind_finish(graph, pass, picture, bloom, nullptr, nullptr, settings);
    pass.storage(graph.data_of("axis tables", axis_tables(encoding)));
    counts = pass.modify(counts);
    pass.dispatch(
        std::clamp((size.width * size.height + group_texels - 1) / group_texels, 1U, most_groups));
    return counts;
}

} // namespace preview
