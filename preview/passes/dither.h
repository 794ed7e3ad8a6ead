// Rounds the finished picture to 8 bits without contours.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// rgba8 of the same size: each value becomes one of its two neighbouring codes, so often as it is
/// near to each. Values that are codes stay as they are.
ImageHandle add_dither(Graph& graph, ImageHandle picture);

} // namespace preview
