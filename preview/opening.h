// The state that the window opens with, from the command line.
#pragma once

#include "preview/options.h"
#include "preview/shown.h"
#include "preview/ui/model.h"

namespace preview {

/// What a scene or picture, newly shown, sets: the camera and the antialiasing.
void take_shown(ui::State& state, const Shown& shown, const Options& options);

/// With the looks read from their files. Throws lutlib::Error.
ui::State opening_state(const Shown& shown, const Options& options);

} // namespace preview
