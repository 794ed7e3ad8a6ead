// The line between sides A and B, over a picture that effects have changed after the looks.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// A picture of the same size and format with the line at that share of its width.
ImageHandle add_split_line(Graph& graph, ImageHandle picture, float split);

} // namespace preview
