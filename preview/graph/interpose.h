// Graphs as experiments: the same frame with one more pass in the middle of it.
#pragma once

#include "preview/graph/graph.h"

#include <functional>

namespace preview {

/// A copy of `graph` in which those that sample `image` sample in its place what the one pass gives
/// that `declare` adds to the copy; it runs right behind the pass that writes `image`. The image
/// may be retired: earlier readers are passes that come later. Who draws over the image still draws
/// over the image itself. Throws std::logic_error when `declare` adds another number of passes.
Graph interposed(const Graph& graph, ImageHandle image,
                 const std::function<ImageHandle(Graph& graph, ImageHandle image)>& declare);

/// Whether any pass samples that version, so that interposed() would change something.
bool is_sampled(const Graph& graph, ImageHandle image);

} // namespace preview
