// The state that the window opens with, from the command line.
#pragma once

#include "preview/cli/options.h"
#include "preview/frame/shown.h"
#include "preview/editor/model.h"

namespace preview {

/// Shows a scene or picture, with its camera, lights and antialiasing.
void take_shown(ui::State& state, std::shared_ptr<const Shown> shown);

/// With the scene or picture and the looks read from their files. Throws lutlib::Error.
ui::State opening_state(const Options& options);

} // namespace preview
