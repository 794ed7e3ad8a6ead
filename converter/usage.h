// What options may not ask for, alone and together. Validators are for CLI::Option::check(); they
// and all functions, which throw UsageError, name the option and what it takes.
#pragma once

#include "lutlib/lut.h"

#include <CLI/App.hpp>

#include <span>
#include <string>
#include <vector>

namespace converter {

CLI::Validator cube_sizes();
CLI::Validator shaper_sizes();
CLI::Validator picture_bits();
/// Finite numbers.
CLI::Validator above_zero();
CLI::Validator zero_or_more();

/// --domain: minimum and maximum, each a number, or "r,g,b" for the channels. Throws UsageError.
lutlib::Domain domain_of(const std::vector<std::string>& ends);

/// Refuses a name whose extension says that the file is no PNG, where nothing else is written.
/// `what` writes it.
void require_png_name(const std::string& path, const std::string& what);

/// Only one of them can be.
void require_one_standard_input(std::span<const std::string> inputs);

/// `-` where one of these outputs is standard output, else empty: where print() may not print. Only
/// one of them can be; unset outputs are empty.
std::string standard_output_of(std::span<const std::string> outputs);

} // namespace converter
