#include "preview/passes/gbuffer.h"

namespace preview {

GBuffer add_gbuffer(Graph& graph, const SceneHandles& scene, Size size, std::vector<Draw> draws) {
    const auto target = [&](std::string_view name, Format format) {
        return graph.image(name, {format, size.width, size.height});
    };
    Pass pass = graph.raster("g-buffer", "gbuffer.vert", "gbuffer.frag");
    pass.storage(scene.vertices);
    pass.storage(scene.objects);
    pass.uniform(scene.view);
    pass.index_buffer(scene.indices);
    pass.draws(std::move(draws));
    GBuffer out;
    out.normal = pass.color(target("normal", Format::rg16ui), {});
    out.material = pass.color(target("material", Format::r32ui), {});
    out.depth = pass.depth(target("depth", Format::d32), 1);
    return out;
}

} // namespace preview
