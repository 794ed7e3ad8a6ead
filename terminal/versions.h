// The versions of what a program uses.
#pragma once

#include <string>

namespace terminal {

/// "OpenColorIO 2.1.2": a line for each library that is loaded on demand; where one cannot be, what
/// to do.
std::string loaded_versions();

/// What holds the processes that read strangers' files, a line; where none can be started, why.
std::string holding_line();

} // namespace terminal
