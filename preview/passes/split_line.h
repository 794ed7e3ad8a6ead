// The border between sides A and B, over a picture that effects have changed after the looks.
#pragma once

#include "preview/finish/wipe.h"
#include "preview/passes/pass.h"

namespace preview {

/// A picture of the same size and format with the border of a comparison that has that shape in it.
ImageHandle add_split_line(Graph& graph, ImageHandle picture, const Compare& compare,
                           const WipeShape& shape);

} // namespace preview
