// A scene or picture that is opened in the window.
#pragma once

#include "preview/editor/model.h"

#include <memory>

namespace preview {

/// Shows a scene or picture, with its camera, lights, usual effects and finish.
void take_shown(editor::State& state, std::shared_ptr<const Shown> shown);

} // namespace preview
