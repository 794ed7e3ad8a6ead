// Names the looks of a comparison on the finished picture.
#pragma once

#include "preview/finish/wipe.h"
#include "preview/passes/pass.h"

#include <array>
#include <string_view>

namespace preview {

/// Writes "A: " or "B: " and a name into corners of what shows that side: the upper ones where a
/// comparison has the sides beside each other, which `wipe` tells of one that a border divides, and
/// A's into the box that it is in. Letters are
/// capitals; what is no letter or figure of ASCII and none of . - _ + : is a question mark. A name
/// that is too long for its side ends where that does.
ImageHandle add_names(Graph& graph, ImageHandle picture, const Compare& compare,
                      std::array<std::string_view, 2> names, const WipeShape& wipe = {1, 0, 0, 0});

} // namespace preview
