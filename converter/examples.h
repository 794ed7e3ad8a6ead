// Command lines that show what a verb is for, at the end of its help.
#pragma once

#include <string>
#include <string_view>

namespace converter {

/// A line each, each with its end of line; empty for an unknown verb.
std::string_view examples_of(std::string_view verb);

} // namespace converter
