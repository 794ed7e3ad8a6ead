// Shows an intermediate as a picture: the debug views.
#pragma once

#include "preview/passes/pass.h"

#include <string_view>

namespace preview {

/// How the numbers of an image become colours.
struct View {
    std::string_view shader;     ///< shaders/view_*.comp
    bool shows_material = false; ///< the image holds numbers of materials
};

/// rgba8 of `size`. `source` may be of another size; then the nearest texel shows. `materials` is
/// the scene's buffer, for views that show a material.
ImageHandle add_view(Graph& graph, ImageHandle source, const View& view, Size size,
                     BufferHandle materials = {});

} // namespace preview
