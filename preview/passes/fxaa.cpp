#include "preview/passes/fxaa.h"

namespace preview {

ImageHandle add_fxaa(Graph& graph, ImageHandle picture) {
    const ImageDesc desc = graph.image_desc(picture);
    Pass pass = graph.compute("fxaa", "fxaa.comp");
    pass.read(picture);
    const ImageHandle out = pass.write(graph.image("antialiased", desc));
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace preview
