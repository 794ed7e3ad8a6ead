// The rows of the LUT formats that need no library. A new one is one file beside this one, its line
// here, in lutlib/CMakeLists.txt and in the table of io/formats.cpp; io/formats/all.h has those
// that need a library.
#pragma once

#include "lutlib/format.h"

namespace lutlib::formats {

extern const FileFormat cube; ///< Adobe/Iridas
extern const FileFormat cube_resolve;
extern const FileFormat flame; ///< Autodesk .3dl
extern const FileFormat lustre;
extern const FileFormat azasset; ///< O3DE

} // namespace lutlib::formats
