#include "preview/passes/view.h"

namespace preview {

ImageHandle add_view(Graph& graph, ImageHandle source, const View& view, Size size,
                     BufferHandle materials) {
    Pass pass = graph.compute("debug view", view.shader);
    pass.read(source);
    const ImageHandle picture =
        pass.write(graph.image("debug view", {Format::rgba8, size.width, size.height}));
    if (view.shows_material) {
        pass.storage(materials);
    }
    pass.dispatch_over(size.width, size.height);
    return picture;
}

} // namespace preview
