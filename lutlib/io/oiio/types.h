// The types of picture that OpenImageIO reads for us.
#pragma once

#include <string>
#include <string_view>

namespace lutlib::io {

/// OpenImageIO's name of the type that a file's first bytes tell; of a Targa, which has no mark
/// there, by what its header may say. Throws Error, about `file`, for a type that is none of ours.
std::string_view type_of_bytes(std::string_view head, const std::string& file);

/// By OpenImageIO's name.
bool is_known_type(std::string_view type);

inline constexpr std::size_t enough_to_tell_type = 64;

} // namespace lutlib::io
