// What a frame is measured for before it is declared.
#pragma once

#include "preview/frame/settings.h"
#include "preview/graph/execute.h"

namespace preview {

/// The largest value of the HDR picture, by a frame of its own, where the frame asks for it: only
/// bloom does, and only where some light would not bloom. Empty, and nothing rendered, elsewhere.
/// Throws as build_frame().
std::optional<float> measured_maximum(Executor& executor, const FrameInputs& inputs,
                                      const FrameSettings& settings);

} // namespace preview
