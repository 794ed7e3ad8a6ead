#include "preview/passes/resolve.h"

namespace preview {

Resolved add_resolve(Graph& graph, Handle source, Size size, float exposure) {
    const Handle zero = graph.fill("clear maximum", graph.buffer("hdr maximum", 4), 0);
    Pass pass = graph.compute("hdr resolve", "resolve.comp");
    pass.constants({size_of(graph, source) == size ? 0U : 1U});
    pass.read(source);
    Resolved out;
    out.hdr = pass.write(graph.image("hdr", {Format::rgba16f, size.width, size.height}));
    out.maximum = pass.modify(zero);
    pass.push(exposure);
    pass.dispatch_over(size.width, size.height, many_each);
    return out;
}

} // namespace preview
