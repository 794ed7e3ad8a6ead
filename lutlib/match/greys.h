// Keeps a learnt lattice from falling along its greys where nothing says that it should.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <span>

namespace lutlib {

/// Changes each channel along the diagonal to the nearest row that rises, or falls where its ends
/// do, by least squares with `support` as weights; nodes beside the diagonal follow, less the
/// farther they are. A channel that falls by more than chance where it is supported, by so many
/// pixels of this `noise` (a standard deviation, 0..1), stays as it is, and is true in the answer.
std::array<bool, 3> make_greys_rise(Lut3D& cube, std::span<const double> support, double noise);

} // namespace lutlib
