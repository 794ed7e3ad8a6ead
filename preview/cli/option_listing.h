// What --list prints.
#pragma once

#include <string>

namespace preview {

/// The tables: scenes, lookups, every choice, the numbers with their ranges and defaults, effects,
/// parts of the frame and lights' controls.
std::string listing();

} // namespace preview
