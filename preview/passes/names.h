// Names the looks of a comparison on the finished picture.
#pragma once

#include "preview/finish/compare.h"
#include "preview/passes/pass.h"

#include <array>
#include <string_view>

namespace preview {

/// Writes "A: " or "B: " and a name into the upper corners of what shows that side. Letters are
/// capitals; what is no letter or figure of ASCII and none of . - _ + : is a question mark. A name
/// that is too long for its side ends where that does.
ImageHandle add_names(Graph& graph, ImageHandle picture, const Compare& compare,
                      std::array<std::string_view, 2> names);

} // namespace preview
