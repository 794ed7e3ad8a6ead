// Shows an intermediate as a picture: the debug views.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// How the numbers of an image become colours, in shaders/view.comp, view_material.comp,
/// view_normal.comp and view_shadow.comp.
enum class ViewMode : std::uint32_t {
    light,     ///< linear light, encoded as sRGB
    codes,     ///< as they are
    depth,     ///< near is bright, on a logarithmic scale
    albedo,    ///< of the material whose number the image holds, encoded as sRGB
    roughness, ///< of that material, as grey
    metalness, ///< of that material, as grey
    emission,  ///< of that material, encoded as sRGB
    normal,    ///< octahedral normals as n / 2 + 1/2
    shadows,   ///< the layers of a depth array side by side
};

/// rgba8 of `size`. `source` may be of another size; then the nearest texel shows. `materials` is
/// the scene's buffer, for the modes that show a material.
ImageHandle add_view(Graph& graph, ImageHandle source, ViewMode mode, Size size,
                     BufferHandle materials = {});

} // namespace preview
