// ASC CDL corrections in files on disk.
#pragma once

#include "lutlib/recipe/color_correction.h"

#include <string>
#include <vector>

namespace lutlib::io {

/// All of a .cc, .ccc or .cdl file. Throws Error.
std::vector<ColorCorrection> read_corrections(const std::string& path);

/// What is there in a collection's place and cannot be read as one.
enum class Unreadable { is_an_error, is_replaced };

/// The bytes of the file at `path` with this correction: of .cc a new file; of .ccc and .cdl the
/// file that is there, with it in place of the one of its id or behind the others, else a new one.
/// Throws Error, and UsageError for another extension.
std::string correction_bytes(const std::string& path, const ColorCorrection& correction,
                             Unreadable there = Unreadable::is_an_error);

} // namespace lutlib::io
