#include "preview/passes/geometry_view.h"

#include <array>

namespace preview {

ImageHandle add_geometry_view(Graph& graph, const SceneHandles& scene, const GeometryView& view,
                              Size size, std::vector<Draw> draws) {
    Pass pass = graph.raster("geometry view", "gbuffer.vert", view.fragment_shader);
    pass.storage(scene.vertices);
    pass.storage(scene.objects);
    pass.uniform(scene.view);
    if (view.shows_material) {
        pass.storage(scene.materials);
        pass.push(std::array{size.width, size.height});
    } else {
        pass.constants({view.state.blends ? 0U : 1U}); // the alpha of what is added
    }
    pass.state(view.state);
    pass.index_buffer(scene.indices);
    pass.draws(std::move(draws));
    const ImageHandle out =
        pass.color(graph.image("geometry", {Format::rgba16f, size.width, size.height}), {});
    if (view.state.depth_test) {
        (void)pass.depth(graph.image("geometry depth", {Format::d32, size.width, size.height}), 1);
    }
    return out;
}

} // namespace preview
