// What several options together may not ask for. All throw UsageError in words that say so.
#pragma once

#include <span>
#include <string>

namespace converter {

/// `-` where one of these outputs is standard output, else empty: where print() may not print. Only
/// one of them can be; unset outputs are empty.
std::string standard_output_of(std::span<const std::string> outputs);

} // namespace converter
