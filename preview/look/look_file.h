// A look that a file held, made ready for the lookup that shall read it.
#pragma once

#include "lutlib/io/look.h"
#include "preview/look/look_bake.h"

#include <string>

namespace preview {

/// `lookup` null: the float table as the look asks to be read, a strip through its own texels. A
/// lookup that reads a picture gets a picture file's codes as they are, and of any other look what
/// `lutconv bake` would make of it. Throws lutlib::Error, and UsageError for a picture whose layout
/// the lookup does not read.
LoadedLook look_for(const lutlib::io::Look& look, const GpuLookup* lookup);

/// LOOK of the command line: a file, or `none`.
LoadedLook load_look(const std::string& path, const GpuLookup* lookup);

} // namespace preview
