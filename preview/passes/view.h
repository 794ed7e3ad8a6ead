// Shows an intermediate as a picture: the debug views.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// How the numbers of an image become colours, in shaders/view.comp, view_normal.comp and
/// view_shadow.comp.
enum class ViewMode : std::uint32_t {
    light,   ///< linear light, encoded as sRGB
    codes,   ///< as they are
    red,     ///< the first channel as grey
    green,   ///< the second channel as grey
    depth,   ///< 1 - depth relative to the near plane: near is bright, on a logarithmic scale
    normal,  ///< octahedral normals as n / 2 + 1/2
    shadows, ///< the layers of a depth array side by side
};

/// rgba8 of `size`. `source` may be of another size; then the nearest texel shows.
Handle add_view(Graph& graph, Handle source, ViewMode mode, Size size);

} // namespace preview
