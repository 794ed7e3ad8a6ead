// Which layout a LUT picture has, told from its content: dimensions alone cannot (a 16-node
// ociolutimage picture has exactly Unreal's size with green and blue swapped).
#pragma once

#include "lutlib/engine/layout.h"

#include <string>
#include <vector>

namespace lutlib {

/// One way of reading a picture as a lattice.
struct Recognition {
    const Layout* layout = nullptr;
    int size = 0;
    int rows = 1; ///< lattices stacked below each other
    /// 1 for an identity in this layout; falls towards 0 and below where the picture's axes do not
    /// grow with their channels, or grow in jumps.
    double score = 0;
};

/// Every reading that the dimensions allow, best first. Empty: no layout has these dimensions.
std::vector<Recognition> recognise(const Picture& picture);

/// The best reading, when it is clearly the best; throws Error naming the candidates otherwise.
Recognition recognise_one(const Picture& picture, const std::string& file);

} // namespace lutlib
