// Shows the finished picture as a row of picture_views() does.
#pragma once

#include "preview/finish/picture_views.h"
#include "preview/passes/pass.h"

namespace preview {

/// What the view is made of.
struct ViewedPicture {
    ImageHandle picture; ///< codes, not clamped
    ImageHandle before;  ///< the same without looks and of the same size, where the row reads it
};

/// Of the picture's size and in that format, with the legend; `level` is that of the zebra, in
/// shares of the range of codes. The row is not that of the picture itself.
ImageHandle add_picture_view(Graph& graph, const ViewedPicture& viewed, const PictureView& row,
                             float level, Format format);

} // namespace preview
