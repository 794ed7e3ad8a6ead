#include "preview/passes/view.h"

namespace preview {

Handle add_view(Graph& graph, Handle source, ViewMode mode, Size size) {
    const char* shader = mode == ViewMode::normal    ? "view_normal.comp"
                         : mode == ViewMode::shadows ? "view_shadow.comp"
                                                     : "view.comp";
    Pass pass = graph.compute("debug view", shader);
    pass.constants({static_cast<std::uint32_t>(mode)});
    pass.read(source);
    const Handle view =
        pass.write(graph.image("debug view", {Format::rgba8, size.width, size.height}));
    pass.dispatch_over(size.width, size.height);
    return view;
}

} // namespace preview
