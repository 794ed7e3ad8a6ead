// How small a file of a picture can be.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace lutlib::io {

/// Throws Error where a file of so many bytes cannot hold the picture that its header tells of:
/// half a file is no picture, and a few bytes must not make a reader take gigabytes. `partial`: a
/// 64th will do.
void check_packing(const OIIO::ImageSpec& spec, std::string_view type, std::size_t file_bytes,
                   const std::string& file, bool partial);

} // namespace lutlib::io
