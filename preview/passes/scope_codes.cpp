#include "preview/passes/scope_codes.h"

#include "preview/finish/scope_codes.h"

namespace preview {

ImageHandle add_scope_codes(Graph& graph, ImageHandle picture, const ScopeLevels& levels) {
    const Size size = size_of(graph, picture);
    Pass pass = graph.compute("encode for scopes", "scope_codes.comp");
    pass.read(picture);
    pass.storage(graph.data_of("scope codes", scope_code_tables(levels)));
    const ImageHandle codes =
        pass.write(graph.image("codes for scopes", {Format::rgba8, size.width, size.height}));
    pass.dispatch_over(size.width, size.height);
    return codes;
}

} // namespace preview
