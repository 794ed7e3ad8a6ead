// How a program says that something went wrong: to people, and to programs that read its JSON.
#pragma once

#include "lutlib/error.h"

#include <string_view>

namespace terminal {

/// "program: what" in a line on standard error; where `in_json`, which is where standard output
/// carries nothing but JSON, also there as {"error": {"message", "file", "line", "exit_code"}}.
/// Returns the exit code.
int complain(std::string_view program, const lutlib::Error& error, int exit_code, bool in_json);

} // namespace terminal
