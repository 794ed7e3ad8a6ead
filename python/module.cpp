#include "lutlib/io/module.h"
#include "lutlib/version.h"
#include "python/parts.h"

#include <dlfcn.h>
#include <filesystem>

namespace lutlib_python {
namespace {

// Of an installed module; in a build, lutlib finds its own beside this one's folder.
void find_modules() {
    Dl_info info{};
    static const char here = 0;
    if (::dladdr(&here, &info) == 0) {
        return;
    }
    std::error_code failed;
    const auto own = std::filesystem::canonical(info.dli_fname, failed).parent_path();
    for (const char* const way : {LUT_MODULES_FROM_PYTHON, ".."}) {
        const auto folder = (own / way).lexically_normal();
        if (!failed && std::filesystem::exists(folder / "lutlib-reader", failed)) {
            return lutlib::io::set_module_folder(folder.string());
        }
    }
}

} // namespace
} // namespace lutlib_python

PYBIND11_MODULE(lutlib, module) {
    using namespace lutlib_python;
    module.doc() = "Colour LUTs: read, write, bake for engines, verify, edit, apply to arrays.\n\n"
                   "Colours are code values, of which 1.0 is the largest code. Arrays have the "
                   "channels r, g, b (and alpha) in their last axis.";
    module.attr("__version__") = lutlib::version;
    find_modules();
    declare_errors(module);
    declare_look(module);
    declare_recipe(module);
    declare_apply(module);
    declare_work(module);
    declare_tables(module);
}
