#pragma once

#include <string>
#include <string_view>

namespace lutlib::io {

/// The part after the last dot of the file name, in lower case and without the dot; else empty.
std::string extension_of(std::string_view path);

} // namespace lutlib::io
