// `lutpreview check`: the renderer's health on this device.
#pragma once

#include "preview/cli/options.h"

namespace preview {

/// Checks what the options name and prints what was found; whether every bound holds.
bool check_renderer(const Options& options);

} // namespace preview
