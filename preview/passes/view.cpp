#include "preview/passes/view.h"

namespace preview {

ImageHandle add_view(Graph& graph, ImageHandle source, const View& view, const ViewOutput& output,
                     BufferHandle materials) {
    const Size size = output.size;
    Pass pass = graph.compute("debug view", view.shader);
    pass.read(source);
    const ImageHandle picture =
        pass.write(graph.image("debug view", {output.format, size.width, size.height}));
    if (view.shows_material) {
        pass.storage(materials);
    }
    pass.constants({output.as_numbers ? 1U : 0U});
    pass.push(output.near_plane);
    pass.dispatch_over(size.width, size.height);
    return picture;
}

} // namespace preview
