#include "lutlib/error.h"

#include <utility>

namespace lutlib {
namespace {

std::string printable(const std::string& text) {
    constexpr std::size_t longest = 60;
    std::string out;
    for (const char c : text.substr(0, longest)) {
        out += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '.' : c;
    }
    return text.size() > longest ? out + "..." : out;
}

// A file's own words may be in it, of any length.
std::string shortened(const std::string& message) {
    constexpr std::size_t longest = 2000;
    if (message.size() <= longest) {
        return message;
    }
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(message[end]) & 0xc0U) == 0x80U) {
        --end; // not within a character of UTF-8
    }
    return message.substr(0, end) + "...";
}

std::string full_text(const std::string& message, const Where& where) {
    std::string out = where.file;
    if (where.line > 0) {
        out += (out.empty() ? "line " : ":") + std::to_string(where.line);
    }
    if (!out.empty()) {
        out += ": ";
    }
    out += message;
    if (!where.text.empty()) {
        out += ": '" + printable(where.text) + "'";
    }
    return out;
}

} // namespace

Error::Error(const std::string& message, Where where)
    : std::runtime_error(full_text(shortened(message), where)), message_(shortened(message)),
      where_(std::move(where)) {}

Error Error::in_file(const std::string& file) const {
    return Error(message_, Where{file, where_.line, where_.text});
}

} // namespace lutlib
