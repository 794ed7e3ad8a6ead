#include "preview/passes/bloom_composite.h"

namespace preview {

ImageHandle add_bloom_composite(Graph& graph, const Finishing& finishing) {
    if (finishing.bloom.plan.empty()) {
        return finishing.picture;
    }
    const Size size = size_of(graph, finishing.picture);
    Pass pass = graph.compute("bloom composite", "bloom_composite.comp");
    bind_finish(graph, pass, {finishing.picture, finishing.bloom, nullptr, nullptr, {}});
    const ImageHandle out =
        pass.write(graph.image("bloomed", {Format::rgba16f, size.width, size.height}));
    pass.dispatch_over(size.width, size.height);
    return out;
}

} // namespace preview
