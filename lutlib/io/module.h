// Shared libraries that are loaded only when a file needs them: OpenImageIO and OpenColorIO cost
// 0.2 s and 130 MB to load on Debian 12, which the way from a .cube to a PNG must not pay.
//
// They are looked for, in this order:
// 1. in the folder that set_module_folder() names;
// 2. in the folders of the environment's LUTLIB_MODULE_PATH, with colons between;
// 3. beside the library itself, at the address that it was loaded to: in the folder lutlib there,
// or
//    of a build in the same folder. A program that has lutlib linked into it is that library, and
//    counts as lying in the bin of a prefix or of a build;
// 4. where the library was to be installed.
// Never in the current folder: relative names are left out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

/// For the whole program; to be said before the first file is read. Throws Error unless the path is
/// absolute. Empty: nothing is named.
void set_module_folder(const std::string& folder);

/// Where modules are looked for, absolute, in order.
std::vector<std::string> module_folders();

/// The first such path that exists of a file that belongs to this library. Throws Error, with the
/// folders and the Debian package that has the file, where there is none.
std::string module_path(const std::string& file);
/// The same in the given folders.
std::string module_path(const std::string& file, const std::vector<std::string>& folders);

/// The address of `symbol` in lib`name`.so at its module_path(). It stays loaded. Throws Error when
/// there is none.
void* module_symbol(const std::string& name, const char* symbol);

/// Why lib`name`.so could not be loaded, as the system's loader gave it, with the package to
/// install.
std::string loading_problem(std::string_view name, const std::string& reason);

} // namespace lutlib::io
