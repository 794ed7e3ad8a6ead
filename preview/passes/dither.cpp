#include "preview/passes/dither.h"

namespace preview {

ImageHandle add_dither(Graph& graph, ImageHandle picture) {
    const Size size = size_of(graph, picture);
    Pass pass = graph.compute("dither", "dither.comp");
    pass.read(picture);
    const ImageHandle out =
        pass.write(graph.image("dithered", {Format::rgba8, size.width, size.height}));
    pass.dispatch_over(size.width, size.height, many_each);
    return out;
}

} // namespace preview
