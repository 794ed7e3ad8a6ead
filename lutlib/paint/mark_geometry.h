// How a marked strip lies since it was placed, to a fraction of a pixel.
#pragma once

#include "lutlib/paint/strip.h"

#include <optional>

namespace lutlib {

struct MarkGeometry {
    double scale = 1;   ///< against the size in which it was placed
    double degrees = 0; ///< by which it was turned, clockwise
};

/// By where the light and dark cells of the mark meet, along its rows and between them; nothing
/// where those places lie on no straight lines. Of a strip that was found with its mark.
std::optional<MarkGeometry> mark_geometry(const Picture& upright, const FoundStrip& strip);

} // namespace lutlib
