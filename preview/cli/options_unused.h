// Options of a command line that change nothing in what it asks for.
#pragma once

#include "preview/cli/options.h"

#include <string>
#include <vector>

namespace preview {

/// A sentence for each that was given, once `app` has been parsed into `options`.
std::vector<std::string> unused_options(const CLI::App& app, const Options& options);

} // namespace preview
