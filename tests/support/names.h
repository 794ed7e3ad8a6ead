// Names of parametrised tests, which may hold letters, digits and underscores only.
#pragma once

#include <string>
#include <string_view>

namespace support {

/// The name of a row or file with an underscore for everything else.
inline std::string test_name(std::string_view name) {
    std::string out(name);
    for (char& c : out) {
        const bool kept =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        c = kept ? c : '_';
    }
    return out;
}

} // namespace support
