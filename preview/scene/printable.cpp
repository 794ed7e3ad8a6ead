#include "preview/scene/printable.h"

#include <algorithm>

namespace preview {

std::string printable(std::string_view text, std::size_t longest) {
    std::string out;
    for (std::size_t at = 0; at < std::min(text.size(), longest); ++at) {
        const auto c = static_cast<unsigned char>(text[at]);
        // Also U+0080 to U+009F, which terminals take for escapes: in UTF-8 after 0xC2.
        const bool is_c1 =
            c >= 0x80 && c < 0xa0 && (at == 0 || static_cast<unsigned char>(text[at - 1]) == 0xc2);
        out += c < 0x20 || c == 0x7f || is_c1 ? '?' : text[at];
    }
    return text.size() > longest ? out + "..." : out;
}

} // namespace preview
