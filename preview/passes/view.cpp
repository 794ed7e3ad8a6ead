#include "preview/passes/view.h"

namespace preview {

namespace {

bool shows_material(ViewMode mode) {
    return mode >= ViewMode::albedo && mode <= ViewMode::emission;
}

const char* shader_of(ViewMode mode) {
    if (shows_material(mode))
        return "view_material.comp";
    if (mode == ViewMode::normal)
        return "view_normal.comp";
    return mode == ViewMode::shadows ? "view_shadow.comp" : "view.comp";
}

} // namespace

ImageHandle add_view(Graph& graph, ImageHandle source, ViewMode mode, Size size,
                     BufferHandle materials) {
    Pass pass = graph.compute("debug view", shader_of(mode));
    pass.constants({static_cast<std::uint32_t>(mode)});
    pass.read(source);
    const ImageHandle view =
        pass.write(graph.image("debug view", {Format::rgba8, size.width, size.height}));
    if (shows_material(mode))
        pass.storage(materials);
    pass.dispatch_over(size.width, size.height);
    return view;
}

} // namespace preview
