// What people hand over in place of a LUT without noticing: a web page, a word processor's file, an
// archive, a pointer to the file. Told by their first bytes, whatever the name says.
#pragma once

#include <string>
#include <string_view>

namespace lutlib {

/// Whether these bytes begin as one of these does.
bool begins_as_mistaken(std::string_view bytes);

/// Throws Error, with the remedy, for bytes that begin as one of these does.
void refuse_mistaken_file(std::string_view bytes, const std::string& file);

} // namespace lutlib
