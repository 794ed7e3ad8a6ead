// The rows of the LUT formats that need a library: OpenColorIO, or libspng for pictures. A new one
// is one file beside this one (or a row in opencolorio.cpp), its line here, in
// lutlib/io/CMakeLists.txt and in the table of io/formats.cpp.
#pragma once

#include "lutlib/format.h"

#include <span>

namespace lutlib::formats {

extern const FileFormat csp;
extern const FileFormat spi1d;
extern const FileFormat spi3d;
/// PNG pictures of the layout that their content shows; where it does not tell, of the engine that
/// their text names. Read-only.
extern const FileFormat png;
/// The same of other types of picture, through OpenImageIO.
extern const FileFormat picture;

/// What OpenColorIO reads and we do not know any better.
std::span<const FileFormat> opencolorios();
/// Pictures in one layout, written as PNG, read of any type: a row for each of layouts().
std::span<const FileFormat> pictures();

} // namespace lutlib::formats
