// What options may not ask for together. All functions, which throw UsageError, name the option and
// what it takes.
#pragma once

#include "lutlib/lut.h"

#include <span>
#include <string>
#include <vector>

namespace converter {

/// --domain: minimum and maximum, each a number, or "r,g,b" for the channels. Throws UsageError.
lutlib::Domain domain_of(const std::vector<std::string>& ends);

/// Refuses a name whose extension says that the file is no PNG, where nothing else is written.
/// `what` writes it.
void require_png_name(const std::string& path, const std::string& what);

/// Only one of them can be.
void require_one_standard_input(std::span<const std::string> inputs);

/// `-` where one of these outputs is standard output, else empty: where print() may not print. Only
/// one of them can be, and no two the same file by any of its paths; unset outputs are empty.
std::string standard_output_of(std::span<const std::string> outputs);

} // namespace converter
