// The paintbrush in double: twin of paintbrush_strokes.comp and paintbrush.comp, which explain it.
#pragma once

#include "preview/reference/image.h"

namespace preview::reference {

/// Lengths in texels and, of strokes, in cells.
struct Paintbrush {
    double strength = 1, cell = 2, half_length = 1;
    double frequency = 0.1; ///< periods of the noise a cell
    double depth = 0;       ///< in the noise
    double coherence = 1;
};
inline constexpr double stroke_half_width = 0.7; ///< in cells

Image painted(const Image& picture, const Paintbrush& brush);

} // namespace preview::reference
