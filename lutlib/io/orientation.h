// Pictures whose stored rows are turned or mirrored.
#pragma once

#include "lutlib/io/image.h"

namespace lutlib::io {

/// The picture with its first row on top and its first column left, of one that is stored in
/// `orientation`, 1..8 (TIFF 6.0, "Orientation"): 1 is upright already, 3 turned by half, 6 has to
/// be turned clockwise by a quarter, 8 anticlockwise; 2, 4, 5 and 7 are mirrored. Any other number
/// is read as 1.
FloatImage upright(const FloatImage& stored, int orientation);

} // namespace lutlib::io
