// The version of lutlib, for programs that are compiled against it. Semantic versioning; while the
// major version is 0, a new minor one may change any interface, and the libraries' SONAME with it.
#pragma once

#include <string_view>

#define LUTLIB_VERSION_MAJOR 0
#define LUTLIB_VERSION_MINOR 2
#define LUTLIB_VERSION_PATCH 0

namespace lutlib {

inline constexpr std::string_view version = "0.2.0";

} // namespace lutlib
