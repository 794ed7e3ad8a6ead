// The effects of a frame: which of them it draws, what they are given, and in what order they
// stand.
#pragma once

#include "preview/effects/effect.h"
#include "preview/frame/settings.h"

#include <string>

namespace preview {

/// Whether a picture is shown that holds a display's codes.
bool is_display_encoded(const FrameInputs& inputs);

/// The effects that a frame draws, and what they are given.
struct DrawnEffects {
    EffectUses uses;
    EffectInput given; ///< but for the picture and its width
};

/// Of a picture of `size`; `handles` has the scene's surfaces. Says why it leaves out the others.
DrawnEffects drawn_effects(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                           Size size, const FrameHandles& handles);

/// Lays the effects of a stage over the picture, one after the other.
ImageHandle with_effects(Graph& graph, Stage stage, const DrawnEffects& drawn, ImageHandle picture,
                         FrameHandles& handles);

/// A line that tells where in the frame the effects stand that it has laid over the picture.
std::string order_text(const FrameHandles& handles);

} // namespace preview
