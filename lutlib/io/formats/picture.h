// LUT pictures as file formats. Node (r,g,b) stands for the input i/(N-1), but in a picture whose
// text names an engine for the input at which that engine reads it.
#pragma once

#include "lutlib/engine/layout.h"
#include "lutlib/lut.h"

namespace lutlib::formats {

/// The lattice size for a look in this layout: `wanted`, or when 0 the look's own or the next
/// larger one that the layout has. Throws UsageError when the layout has no picture of `wanted`.
int picture_cube_size(const Layout& layout, const Lut& lut, int wanted);

} // namespace lutlib::formats
