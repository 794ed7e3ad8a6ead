#include "preview/passes/axes.h"

namespace preview {

BufferHandle add_axes(Graph& graph, const Finishing& finishing, const lutlib::Encoding& encoding) {
    const Size size = size_of(graph, finishing.picture);
    Finishing without_looks = finishing;
    without_looks.look_a = without_looks.look_b = nullptr;
    BufferHandle counts =
        graph.buffer("axis counts", sizeof(std::uint32_t) * axis_bins * counted_axes.size());
    counts = graph.fill("clear axis counts", counts, 0);
    Pass pass = graph.compute("count along axes", "axes.comp");
    bind_finish(graph, pass, without_looks);
    pass.storage(graph.data_of("axis tables", axis_tables(encoding)));
    counts = pass.modify(counts);
    pass.dispatch(counting_groups(std::uint64_t{size.width} * size.height));
    return counts;
}

} // namespace preview
