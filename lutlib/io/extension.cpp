#include "lutlib/io/extension.h"

#include <algorithm>

namespace lutlib::io {

std::string extension_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const std::size_t dot = file.rfind('.');
    std::string out(dot == std::string_view::npos ? std::string_view{} : file.substr(dot + 1));
    std::transform(out.begin(), out.end(), out.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return out;
}

} // namespace lutlib::io
