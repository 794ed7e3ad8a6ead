// A part of the finished picture, pixel by pixel, in the output.
#pragma once

#include "preview/finish/zoom.h"
#include "preview/passes/pass.h"

namespace preview {

/// The grey about a picture that does not fill the output, as a code: dark and neutral, as ISO
/// 3664:2009 asks of a surround.
inline constexpr float surround_code = 46.0F / 255;

struct Magnifying {
    ZoomPlace place;
    const Magnifier* magnifier = &magnifiers.front();
    Size output{};        ///< of one of two pictures side by side half
    bool is_pair = false; ///< the picture is two, side by side, and so is the output
    float heat_scale = 0; ///< of the scale that is drawn over it; 0: none is
};

/// An image of the picture's format and the output's size.
ImageHandle add_magnify(Graph& graph, ImageHandle picture, const Magnifying& how);

} // namespace preview
