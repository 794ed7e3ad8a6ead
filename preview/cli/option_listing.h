// What --list prints.
#pragma once

#include "terminal/table.h"

namespace preview {

/// The tables: scenes, lookups, every choice, the numbers with their ranges and defaults, effects,
/// parts of the frame and lights' controls.
terminal::Table listing();

} // namespace preview
