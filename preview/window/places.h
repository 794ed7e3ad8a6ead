// Where the controls are, for scripts that press them.
#pragma once

#include "preview/panels/ui.h"

#include <string>

namespace preview {

/// Writes the file that --places describes; no path, no file. Throws lutlib::Error.
void write_places(const panels::Ui& ui, const std::string& path);

} // namespace preview
