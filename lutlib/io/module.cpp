#include "lutlib/io/module.h"

#include "lutlib/error.h"

#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <link.h>
#include <mutex>
#include <sstream>
#include <system_error>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

// What a module brings into the process, by the names of Debian 12.
struct ModuleLibrary {
    std::string_view module, library, package;
};
constexpr std::array<ModuleLibrary, 3> module_libraries{{
    {"lutlib_ocio", "OpenColorIO", "libopencolorio2.1"},
    {"lutlib_oiio", "OpenImageIO", "libopenimageio2.4"},
    {"lutpreview_obj", "assimp", "libassimp5"},
}};

// Of ours, which holds the file.
std::string own_package_with(const std::string& file) {
    return file.starts_with("liblutpreview") ? "lutpreview" : "lutconv";
}

std::mutex chosen_mutex;
std::string chosen_folder;

// What this code was loaded from. The system's loader has no name for the program itself, and keeps
// a relative one of a library, which may mean another by now.
struct Own {
    bool in_program = false; ///< linked into it
    fs::path folder;         ///< empty where it is not known
};

Own own_place() {
    Dl_info info{};
    link_map* map = nullptr;
    const auto* const here = reinterpret_cast<const void*>(&module_folders);
    if (::dladdr1(here, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) == 0 || !map) {
        return {};
    }
    const bool in_program = !map->l_name || *map->l_name == '\0';
    const fs::path file = in_program ? "/proc/self/exe" : map->l_name;
    std::error_code failed;
    const fs::path real = file.is_absolute() ? fs::canonical(file, failed) : fs::path();
    return {in_program, failed ? fs::path() : real.parent_path()};
}

void append_absolute(std::vector<std::string>& folders, const fs::path& folder) {
    if (folder.is_absolute()) {
        folders.push_back(folder.lexically_normal().string());
    }
}

} // namespace

void set_module_folder(const std::string& folder) {
    if (!folder.empty() && !fs::path(folder).is_absolute()) {
        throw Error("give the folder of lutlib's modules with its whole path, not '" + folder +
                    "'");
    }
    const std::lock_guard lock(chosen_mutex);
    chosen_folder = folder;
}

std::vector<std::string> module_folders() {
    std::vector<std::string> out;
    {
        const std::lock_guard lock(chosen_mutex);
        append_absolute(out, chosen_folder);
    }
    if (const char* const named = ::secure_getenv("LUTLIB_MODULE_PATH")) {
        std::istringstream words(named);
        for (std::string folder; std::getline(words, folder, ':');) {
            append_absolute(out, folder);
        }
    }
    if (const Own own = own_place(); !own.folder.empty() && own.in_program) {
        append_absolute(out, own.folder / LUT_MODULES_FROM_PROGRAM);
        append_absolute(out, own.folder / "../lib");
    } else if (!own.folder.empty()) {
        append_absolute(out, own.folder / "lutlib");
        append_absolute(out, own.folder);
    }
    append_absolute(out, LUT_MODULES_LAST);
    return out;
}

std::string module_path(const std::string& file, const std::vector<std::string>& folders) {
    std::string tried;
    for (const std::string& folder : folders) {
        const fs::path place = fs::path(folder) / file;
        std::error_code none;
        if (fs::exists(place, none)) {
            return place.string();
        }
        tried += (tried.empty() ? "" : ", ") + folder;
    }
    throw Error("install the Debian package " + own_package_with(file) +
                ", or name the folder that holds " + file +
                " in LUTLIB_MODULE_PATH: it is not in " + tried);
}

std::string module_path(const std::string& file) {
    return module_path(file, module_folders());
}

std::string loading_problem(std::string_view name, const std::string& reason) {
    for (const ModuleLibrary& row : module_libraries) {
        const bool lacks_library =
            row.module == name && reason.find("lib" + std::string(row.library)) < reason.find(':');
        if (lacks_library) {
            return "install the Debian package " + std::string(row.package) +
                   ", which this needs: " + reason;
        }
    }
    return "cannot load lib" + std::string(name) + ".so: " + reason;
}

void* module_symbol(const std::string& name, const char* symbol) {
    void* const module = ::dlopen(module_path("lib" + name + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const address = module ? ::dlsym(module, symbol) : nullptr;
    if (!address) {
        const char* const reason = ::dlerror();
        throw Error(loading_problem(name, reason ? reason : "unknown reason"));
    }
    return address;
}

} // namespace lutlib::io
