// What the contents of a version are made from.
#pragma once

#include "preview/graph/graph.h"

#include <string>

namespace preview {

/// Equal for two versions, of the same graph or of two, when the passes that lead to them would
/// write the same: they say the same, in the same order, and read the same bytes of data() and the
/// same imported objects. Never empty. Names do not count.
std::string fingerprint_of(const Graph& graph, std::uint32_t version);

} // namespace preview
