// What is kept of a picture's file, as bytes for another process.
#pragma once

#include "lutlib/io/oiio/kept.h"

namespace lutlib::io {

std::string packed_source(const OiioSource& source);
/// Throws Error for bytes that packed_source() did not make.
std::shared_ptr<const OiioSource> unpacked_source(std::string_view bytes);

} // namespace lutlib::io
