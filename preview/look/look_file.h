// LOOK of the command line: a LUT file or picture, made ready for the lookup that shall read it.
#pragma once

#include "preview/look/look_bake.h"

#include <string>

namespace preview {

/// Reads `path`: `none`, a LUT picture, or any LUT file that lutlib reads. `lookup` null: the float
/// table tetrahedrally, a strip through its own texels. A lookup that reads a picture gets a
/// picture file's codes as they are, and of any other look what `lutconv bake` would make of it.
/// Throws lutlib::Error, and UsageError for a picture whose layout the lookup does not read.
LoadedLook load_look(const std::string& path, const Lookup* lookup);

} // namespace preview
