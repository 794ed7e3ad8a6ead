#include "preview/passes/probe.h"

#include <algorithm>

namespace preview {

BufferHandle add_probe(Graph& graph, const Finishing& finishing, ProbePlace place) {
    const Size size = size_of(graph, finishing.picture);
    const std::array<std::int32_t, 2> texel{
        std::clamp(place.x, 0, static_cast<std::int32_t>(size.width) - 1),
        std::clamp(place.y, 0, static_cast<std::int32_t>(size.height) - 1)};
    Pass pass = graph.compute("probe", "probe.comp");
    bind_finish(graph, pass, finishing);
    pass.uniform(graph.data_of("probed place", texel));
    const BufferHandle out = pass.write(graph.buffer("probe", 12 * sizeof(float)));
    pass.dispatch(1);
    return out;
}

} // namespace preview
