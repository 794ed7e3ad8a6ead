// What libraries say of a file, for people.
#pragma once

#include <string>

namespace lutlib::io {

/// A library's text in a line of at most 300 bytes: the file by `file` where it says `path`, and
/// what it calls a lack of memory in words.
std::string condensed(std::string text, const std::string& path, const std::string& file);

/// What of OpenColorIO's text about a file helps: the reason of the reader that the file's
/// extension calls for, without the formats that were tried.
std::string reason_of_opencolorio(const std::string& text);

} // namespace lutlib::io
