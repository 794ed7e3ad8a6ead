// A scene or picture that is opened in the window.
#pragma once

#include "preview/editor/model.h"

#include <memory>

namespace preview {

/// Shows a scene or picture, with its camera, lights, usual effects and finish.
void take_shown(editor::State& state, std::shared_ptr<const Shown> shown);

/// What the state shows, as its files have it now: the camera and all settings stay, and so do
/// lights that a person has changed.
void take_shown_again(editor::State& state, const std::shared_ptr<const Shown>& fresh);

} // namespace preview
