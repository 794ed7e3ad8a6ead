// How strangers' files are read: --no-sandbox, --max-memory and --allow-outside, of every verb that
// reads any.
#pragma once

#include "converter/verb.h"

#include <string>

namespace converter {

void declare_reading_limits(Verb& verb);
/// As the options say, once they are read. Says on standard error that there is no sandbox.
void apply_reading_limits();

/// The versions of what the program uses, and what holds the readers of strangers' files; a line
/// each. Throws lutlib::Error where a library is not installed.
std::string verbose_version();

} // namespace converter
