// What becomes of a look in a file that somebody else's reader will read.
#pragma once

#include "lutlib/format.h"

#include <optional>
#include <string>

namespace lutlib::io {

/// The file read by the reader that OpenColorIO has for the format, and evaluated by it, against
/// the look that was written: by how much the largest channel differs, beyond the rounding that
/// `holds` says; nothing where it does not. Throws Error where the file cannot be read.
std::optional<Loss> lost_in_reading(const FileFormat& format, const std::string& bytes,
                                    const Lut& written);

} // namespace lutlib::io
