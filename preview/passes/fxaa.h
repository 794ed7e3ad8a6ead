// Fast approximate antialiasing of the finished picture.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// A picture of the same size and format. Takes display-encoded values.
ImageHandle add_fxaa(Graph& graph, ImageHandle picture);

} // namespace preview
