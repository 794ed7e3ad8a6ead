// LUT pictures in every layout as file formats. Node (r,g,b) stands for the input i/(N-1), but in a
// picture whose text names an engine for the input at which that engine reads it.
#pragma once

#include "lutlib/engine/layout.h"
#include "lutlib/io/formats.h"

namespace lutlib::io {

/// PNG pictures of 8 and 16 bits in one layout.
FileFormat picture_format(const Layout& layout);
/// PNG pictures of the layout of the engine that their text names, else of the layout that their
/// content shows; read-only.
FileFormat recognised_picture_format();

/// The lattice size for a look in this layout: `wanted`, or when 0 the look's own or the next
/// larger one that the layout has. Throws UsageError when the layout has no picture of `wanted`.
int picture_cube_size(const Layout& layout, const Lut& lut, int wanted);

} // namespace lutlib::io
