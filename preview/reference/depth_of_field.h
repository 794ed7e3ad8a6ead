// Depth of field by brute force, in double: every texel that is before the focus is spread over its
// own circle, and every other gathers all that reach it, at full resolution.
// shaders/depth_of_field*.comp do that by halved layers and 49 points.
#pragma once

#include "preview/reference/image.h"

#include <vector>

namespace preview::reference {

struct ThinLens {
    double focal = 0.05;   ///< metres
    double aperture = 2;   ///< N of f/N
    double sensor = 0.024; ///< height, metres
    double focus = 2;      ///< metres
    double largest = 1e9;  ///< radius, texels
};

/// Radius of the circle of a point at z metres, in texels of a picture of so many rows: above 0
/// behind the focus, below 0 before it. An infinite z is the background's.
double circle_radius(const ThinLens& lens, double z, int rows);

/// `radii`: of each pixel.
Image focused(const Image& light, const std::vector<double>& radii);

} // namespace preview::reference
