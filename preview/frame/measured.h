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

/// The exposure, in place of that of the settings, that makes what is at that texel of the output,
/// as zoomed as the settings have it, 18 % grey; without a place, the mean of the picture. In the
/// range of exposures; before bloom and effects. Empty: it is dark, or a display-encoded picture,
/// which holds no light.
std::optional<float> metered_exposure(Executor& executor, const FrameInputs& inputs,
                                      const FrameSettings& settings,
                                      std::optional<ProbePlace> place);

} // namespace preview
