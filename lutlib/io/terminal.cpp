#include "lutlib/io/terminal.h"

#include "lutlib/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace lutlib::io {
namespace {

struct Character {
    char32_t code = 0;
    std::size_t bytes = 0; ///< 0: no UTF-8
};

// RFC 3629.
Character first_of(std::string_view text) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const unsigned char lead = byte(0);
    const std::size_t length = lead < 0x80             ? 1
                               : (lead & 0xe0) == 0xc0 ? 2
                               : (lead & 0xf0) == 0xe0 ? 3
                               : (lead & 0xf8) == 0xf0 ? 4
                                                       : 0;
    if (length == 0 || length > text.size()) {
        return {};
    }
    char32_t code = length == 1 ? lead : lead & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) {
            return {};
        }
        code = code << 6 | (byte(i) & 0x3f);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = code >= 0xd800 && code < 0xe000;
    return code < least[length] || code > 0x10ffff || is_surrogate ? Character{}
                                                                   : Character{code, length};
}

// Unicode 15: Cc; Bidi_Control; the line and paragraph separators.
bool is_unseen(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x061c || code == 0x200e ||
           code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

std::string spelled(char32_t code) {
    switch (code) {
    case '\n':
        return "\\n";
    case '\r':
        return "\\r";
    case '\t':
        return "\\t";
    default:
        return code < 0x80 ? fmt::format("\\x{:02x}", static_cast<unsigned>(code))
                           : fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    }
}

bool output_was_closed = false;

} // namespace

std::string shown_text(std::string_view text, char kept) {
    std::string out;
    while (!text.empty()) {
        const Character c = first_of(text);
        const std::size_t bytes = std::max<std::size_t>(c.bytes, 1);
        if (c.bytes == 0) {
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        } else if (is_unseen(c.code) && text.front() != kept) {
            out += spelled(c.code);
        } else {
            out += text.substr(0, bytes);
        }
        text.remove_prefix(bytes);
    }
    return out;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t bytes = first_of(text).bytes;
        if (bytes == 0) {
            return false;
        }
        text.remove_prefix(bytes);
    }
    return true;
}

void open_standard_streams() {
    int lowest_free = 0;
    do {
        lowest_free = ::open("/dev/null", O_RDWR);
        output_was_closed = output_was_closed || lowest_free == STDOUT_FILENO;
    } while (lowest_free >= 0 && lowest_free <= STDERR_FILENO);
    ::close(lowest_free);
}

bool standard_output_was_closed() {
    return output_was_closed;
}

void print_marked(const std::string& shown) {
    if (std::fputs(shown.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
        throw Error("cannot write standard output: " + std::generic_category().message(errno));
    }
}

void print_out(std::string_view text) {
    print_marked(shown_text(text, '\n'));
}

void print_err(std::string_view text) {
    std::fputs(shown_text(text, '\n').c_str(), stderr);
}

} // namespace lutlib::io
