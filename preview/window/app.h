// The window: the scene or picture, two looks, and the panels to author one.
#pragma once

#include "preview/cli/options.h"

namespace preview {

/// Runs until the window is closed. Redraws on input, on new looks and on nothing else. Throws
/// lutlib::Error when no window can be had.
void run_window(const Options& options);

} // namespace preview
