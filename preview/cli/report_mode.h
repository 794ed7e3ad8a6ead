// `lutpreview report`: what passes cost in error and time, and what to take for a budget.
#pragma once

#include "preview/cli/options.h"

namespace preview {

/// Measures what the options name, writes the page and prints the choice; whether the budget or
/// error that was asked for is kept. Throws lutlib::Error, and UsageError.
bool report_renderer(const Options& options);

} // namespace preview
