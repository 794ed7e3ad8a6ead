// Copies an image texel by texel: the cheapest full-screen pass there is, against which the others
// are measured, and a change of format.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// An image of the same size in `format`.
ImageHandle add_copy(Graph& graph, ImageHandle source, Format format);

} // namespace preview
