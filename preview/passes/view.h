// Shows an intermediate as a picture: the debug views.
#pragma once

#include "preview/passes/gbuffer.h"

#include <string_view>

namespace preview {

/// How the numbers of an image become colours.
struct View {
    std::string_view shader;     ///< shaders/view_*.comp
    bool shows_material = false; ///< the image holds numbers of materials
};

/// What a view is made for.
struct ViewOutput {
    Size size;
    Format format = Format::rgba8;
    /// The numbers themselves in place of colours that stand for them: light, metres of depth,
    /// components of normals.
    bool as_numbers = false;
    float near_plane = 1; ///< of the camera, in metres
};

/// `source` may be of another size; then the nearest texel shows. `materials` is the scene's
/// buffer and `surfaces` what it shows, for views that show a material.
ImageHandle add_view(Graph& graph, ImageHandle source, const View& view, const ViewOutput& output,
                     BufferHandle materials = {}, const GBuffer& surfaces = {});

} // namespace preview
