#include "preview/passes/split_line.h"

namespace preview {

ImageHandle add_split_line(Graph& graph, ImageHandle picture, float split) {
    const ImageDesc desc = graph.image_desc(picture);
    Pass pass = graph.compute("split line", "split_line.comp");
    pass.read(picture);
    const ImageHandle out = pass.write(graph.image("with split line", desc));
    pass.push(split);
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace preview
