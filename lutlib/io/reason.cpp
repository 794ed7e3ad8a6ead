#include "lutlib/io/reason.h"

#include <new>
#include <stdexcept>

namespace lutlib::io {

std::string reason_of(const std::exception& error) {
    // A container that is asked for more than can exist says so by length_error.
    if (!dynamic_cast<const std::bad_alloc*>(&error) &&
        !dynamic_cast<const std::length_error*>(&error)) {
        return error.what();
    }
    const std::string& file = last_input();
    return (file.empty() ? "" : file + ": ") + "it takes more memory than there is";
}

} // namespace lutlib::io
