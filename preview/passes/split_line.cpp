#include "preview/passes/split_line.h"

namespace preview {

ImageHandle add_split_line(Graph& graph, ImageHandle picture, const Compare& compare,
                           const WipeShape& shape) {
    const ImageDesc desc = graph.image_desc(picture);
    Pass pass = graph.compute("split line", "split_line.comp");
    pass.constants({&compare == &compare_box});
    pass.read(picture);
    const ImageHandle out = pass.write(graph.image("with split line", desc));
    pass.push(shape);
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace preview
