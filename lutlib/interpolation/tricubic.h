// Tricubic interpolation of a lattice, for resampling smooth looks.
//
// R. G. Keys, "Cubic convolution interpolation for digital image processing", 1981, with a = -1/2,
// along each axis and with his extrapolation beyond the lattice's faces (a parabola through the
// last three nodes): it passes through the nodes with a continuous derivative and is exact for
// quadratics. Next to a sharp bend it overshoots, by up to 1/8 of the bend's step.
#pragma once

#include "lutlib/lut.h"

namespace lutlib {

/// Inputs outside the domain are clamped to it; NaN reads as its minimum.
RgbD tricubic(const Lut3D& cube, RgbD in);

} // namespace lutlib
