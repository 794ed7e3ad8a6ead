// LUT pictures in every layout as file formats: node (r,g,b) stands for the input i/(N-1).
#pragma once

#include "lutlib/engine/layout.h"
#include "lutlib/io/formats.h"

namespace lutlib::io {

/// PNG pictures of 8 and 16 bits in one layout.
FileFormat picture_format(const Layout& layout);
/// PNG pictures of whatever layout their content shows; read-only.
FileFormat recognised_picture_format();

/// The lattice size for a look in this layout: `wanted`, or when 0 the look's own or the next
/// larger one that the layout has. Throws UsageError when the layout has no picture of `wanted`.
int picture_cube_size(const Layout& layout, const Lut& lut, int wanted);

} // namespace lutlib::io
