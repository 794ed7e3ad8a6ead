#include "lutlib/io/module.h"

#include "lutlib/error.h"

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

std::filesystem::path program_folder() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
}

} // namespace

std::string module_path(const std::string& file) {
    const std::filesystem::path folder = program_folder();
    for (const auto& place : {folder / "../lib" / file, folder / file}) {
        std::error_code none;
        if (std::filesystem::exists(place, none)) {
            return place.string();
        }
    }
    return file;
}

void* module_symbol(const std::string& name, const char* symbol) {
    const std::string file = "lib" + name + ".so";
    void* const module = ::dlopen(module_path(file).c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const address = module ? ::dlsym(module, symbol) : nullptr;
    if (!address) {
        const char* const reason = ::dlerror();
        throw Error("cannot load " + file + " (" + (reason ? reason : "unknown reason") +
                    "); it belongs in the folder lib beside the program's own");
    }
    return address;
}

} // namespace lutlib::io
