#include "preview/passes/probe.h"

#include "preview/passes/magnify.h"

#include <algorithm>

namespace preview {

namespace {

struct PlaceBlock {
    std::array<std::int32_t, 4> at, extent_a, extent_b;
    std::array<float, 4> surround;
};

} // namespace

BufferHandle add_probe(Graph& graph, const Finishing& finishing, ProbePlace place,
                       const std::array<StillSide, 2>& stills) {
    const Size size = size_of(graph, finishing.picture);
    const PlaceBlock block{{std::clamp(place.x, 0, static_cast<std::int32_t>(size.width) - 1),
                            std::clamp(place.y, 0, static_cast<std::int32_t>(size.height) - 1), 0,
                            0},
                           place_of(stills[0].extent, size),
                           place_of(stills[1].extent, size),
                           {surround_code, surround_code, surround_code, 1}};
    Pass pass = graph.compute("probe", "probe.comp");
    bind_finish(graph, pass, finishing,
                std::array{std::uint32_t{static_cast<bool>(stills[0].picture)},
                           std::uint32_t{static_cast<bool>(stills[1].picture)}});
    pass.storage(graph.data_of("probed place", block));
    const BufferHandle out = pass.write(graph.buffer("probe", 12 * sizeof(float)));
    pass.read(stills[0].picture);
    pass.read(stills[1].picture);
    pass.dispatch(1);
    return out;
}

} // namespace preview
