#include "preview/passes/copy.h"

namespace preview {

Handle add_copy(Graph& graph, Handle source, Format format) {
    const Size size = size_of(graph, source);
    Pass pass = graph.compute("copy", "copy.comp");
    pass.read(source);
    const Handle copy = pass.write(graph.image("copy", {format, size.width, size.height}));
    pass.dispatch_over(size.width, size.height, many_each);
    return copy;
}

} // namespace preview
