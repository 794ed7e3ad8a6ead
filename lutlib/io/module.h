// Shared libraries that are loaded only when a file needs them: OpenImageIO and OpenColorIO cost
// 0.2 s and 130 MB to load on Debian 12, which the way from a .cube to a PNG must not pay.
#pragma once

#include <string>

namespace lutlib::io {

/// The address of `symbol` in lib`name`.so, which lies in ../lib of the running program, beside it,
/// or where the system finds libraries. It stays loaded. Throws Error when there is none.
void* module_symbol(const std::string& name, const char* symbol);

} // namespace lutlib::io
