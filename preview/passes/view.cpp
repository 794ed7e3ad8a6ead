#include "preview/passes/view.h"

namespace preview {

ImageHandle add_view(Graph& graph, ImageHandle source, const View& view, const ViewOutput& output,
                     BufferHandle materials, const GBuffer& surfaces) {
    const Size size = output.size;
    Pass pass = graph.compute("debug view", view.shader);
    pass.read(source);
    const ImageHandle picture =
        pass.write(graph.image("debug view", {output.format, size.width, size.height}));
    const std::uint32_t as_numbers = output.as_numbers ? 1 : 0;
    if (view.shows_material) {
        pass.constants({as_numbers, surfaces.albedo ? 1U : 0U});
        pass.storage(materials);
        pass.read(surfaces.albedo);
        pass.read(surfaces.emission);
    } else {
        pass.constants({as_numbers});
    }
    pass.push(output.near_plane);
    pass.dispatch_over(size.width, size.height);
    return picture;
}

} // namespace preview
