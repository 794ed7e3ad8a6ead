// Depths as OpenImageIO's types, and the errors of the library and of a picture's size.
#pragma once

#include "lutlib/io/image.h"

#include <OpenImageIO/imageio.h>

#include <string>

namespace lutlib::io {

OIIO::TypeDesc type_of(Depth depth);
/// The nearest; numbers that are neither codes of 8 or 16 bits nor halves are floats.
Depth depth_of(const OIIO::TypeDesc& type);

/// Throws Error about `file` with `message` and OpenImageIO's `reason`, whose lines may be many and
/// which may name `path`.
[[noreturn]] void fail(const std::string& message, std::string reason, const std::string& path,
                       const std::string& file);

/// Throws Error about `file` for a picture outside limits.h.
void check_size(const OIIO::ImageSpec& spec, const std::string& file);

} // namespace lutlib::io
