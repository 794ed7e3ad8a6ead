// The bloom's last filter and its sum with the light as a pass of its own, for effects that read
// the light with its bloom. Else the finishing pass does it.
#pragma once

#include "preview/passes/finish.h"

namespace preview {

/// rgba16f of the picture's size; the picture itself where there is no bloom.
ImageHandle add_bloom_composite(Graph& graph, const Finishing& finishing);

} // namespace preview
