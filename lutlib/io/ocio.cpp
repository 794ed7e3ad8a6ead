#include "lutlib/io/ocio.h"

#include "lutlib/io/file.h"
#include "lutlib/io/module.h"

namespace lutlib::io {

const Ocio& ocio() {
    using Entry = const Ocio* (*)();
    static const Ocio* const library =
        reinterpret_cast<Entry>(module_symbol("lutlib_ocio", "lutlib_ocio"))();
    return *library;
}

Transform open_in_ocio(const std::string& path, const EvaluationOptions& options) {
    const auto own = ocio().open(path, options);
    return own ? *own : ocio().parse(read_file(path), extension_of(path), path, options);
}

} // namespace lutlib::io
