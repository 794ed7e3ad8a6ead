#include "preview/scene/printable.h"

#include "lutlib/io/terminal.h"

namespace preview {

std::string printable(std::string_view text, std::size_t longest) {
    const std::string shown = lutlib::io::shown_text(text.substr(0, longest));
    return text.size() > longest ? shown + "..." : shown;
}

} // namespace preview
