#include "preview/passes/axes.h"

namespace preview {

BufferHandle add_axes(Graph& graph, ImageHandle picture, const BloomLayers& bloom,
                      const FinishSettings& settings, const lutlib::Encoding& encoding) {
    const Size size = size_of(graph, picture);
    BufferHandle counts =
        graph.buffer("axis counts", sizeof(std::uint32_t) * axis_bins * counted_axes.size());
    counts = graph.fill("clear axis counts", counts, 0);
    Pass pass = graph.compute("count along axes", "axes.comp");
    bind_finish(graph, pass, picture, bloom, nullptr, nullptr, settings);
    pass.storage(graph.data_of("axis tables", axis_tables(encoding)));
    counts = pass.modify(counts);
    pass.dispatch(counting_groups(std::uint64_t{size.width} * size.height));
    return counts;
}

} // namespace preview
