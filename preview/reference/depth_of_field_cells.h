// Depth of field as shaders/depth_of_field*.comp make it, in double: by layers of cells, points of
// a disc and a fill between them. preview/reference/depth_of_field.h is what that stands for.
#pragma once

#include "preview/reference/image.h"

#include <vector>

namespace preview::reference {

struct CellBlur {
    int cell = 2;       ///< side, in texels
    int rings = 3;      ///< of points
    double largest = 1; ///< radius, in texels
};

/// `radii`: of each texel's circle, above 0 behind the focus.
Image focused_by_cells(const Image& light, const std::vector<double>& radii, const CellBlur& blur);

} // namespace preview::reference
