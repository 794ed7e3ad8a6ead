#include "preview/passes/copy.h"

namespace preview {

ImageHandle add_copy(Graph& graph, ImageHandle source, Format format) {
    const Size size = size_of(graph, source);
    Pass pass = graph.compute("copy", "copy.comp");
    pass.constants({format == Format::rgba8});
    pass.read(source);
    const ImageHandle copy = pass.write(graph.image("copy", {format, size.width, size.height}));
    pass.dispatch_over(size.width, size.height, many_each);
    return copy;
}

} // namespace preview
