// Text from models, which may go to a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace preview {

/// The first bytes of a file's text, as lutlib::io::shown_text() spells them out.
std::string printable(std::string_view text, std::size_t longest = 80);

} // namespace preview
