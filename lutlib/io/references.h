// Files that a file names: a recipe's base, a model's buffers and pictures. Whoever made the file
// chose the names, so they lead to regular files in its own folder and nowhere else.
#pragma once

#include "lutlib/limits.h"

#include <cstddef>
#include <string>

namespace lutlib::io {

/// Whether references may lead out of that folder, here and in every thread; at first they may not.
void allow_references_outside(bool allowed);

/// Whether the file that the file at `from` names as `reference` lies outside the folder of `from`,
/// once the links of both are followed. It need not be there. `-` lies in the current folder.
bool leads_outside(const std::string& from, const std::string& reference);

/// Where that file lies, for messages too.
std::string referenced_path(const std::string& from, const std::string& reference);

/// Its bytes. Throws Error as read_file() does, for what is no regular file (a device or a pipe
/// would be waited for, or never end), and for one outside where that is not allowed.
std::string read_reference(const std::string& from, const std::string& reference,
                           std::size_t max_bytes = limits::max_file_bytes);

} // namespace lutlib::io
