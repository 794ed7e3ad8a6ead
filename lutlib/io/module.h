// Shared libraries that are loaded only when a file needs them: OpenImageIO and OpenColorIO cost
// 0.2 s and 130 MB to load on Debian 12, which the way from a .cube to a PNG must not pay.
#pragma once

#include <string>

namespace lutlib::io {

/// Where a file that belongs to this library lies: in ../lib of the running program or beside it;
/// else its bare name, which the system may know.
std::string module_path(const std::string& file);

/// The address of `symbol` in lib`name`.so, which lies at its module_path(), or where the system
/// finds libraries. It stays loaded. Throws Error when there is none.
void* module_symbol(const std::string& name, const char* symbol);

} // namespace lutlib::io
