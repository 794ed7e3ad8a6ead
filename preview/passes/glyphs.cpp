#include "preview/passes/glyphs.h"

#include <string_view>

namespace preview {

std::uint32_t glyph_of(char c) {
    constexpr std::string_view order = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ.-_+:?";
    if (c == ' ') {
        return no_glyph;
    }
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    const std::size_t place = order.find(upper);
    return static_cast<std::uint32_t>(place == std::string_view::npos ? order.size() - 1 : place);
}

} // namespace preview
