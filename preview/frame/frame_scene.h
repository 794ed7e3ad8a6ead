// The scene's part of a frame, from its declaration to its light.
#pragma once

#include "preview/frame/settings.h"

namespace preview {

/// Radiance of inputs.scene in a picture of `size`, not yet exposed; fills in what it is made of,
/// and says what it leaves out.
ImageHandle render_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                         Size size, FrameHandles& handles);

} // namespace preview
