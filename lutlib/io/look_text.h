// What whoever uses a look must know of how its files were read, as lines for people.
#pragma once

#include "lutlib/io/look.h"

#include <string>
#include <vector>

namespace lutlib::io {

/// A line for everything that was lost, guessed or is not acted on, the file's name before those of
/// a recipe's base. Control characters are escaped.
std::vector<std::string> told_of(const Look& look);

} // namespace lutlib::io
