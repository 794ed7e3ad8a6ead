// A frame that compares its finished picture with a reference still. A part of build_frame().
#pragma once

#include "preview/frame/settings.h"
#include "preview/graph/graph.h"

namespace preview {

/// Whether the comparison shows a side that is a still.
bool compares_stills(const FrameInputs& inputs, const FrameSettings& settings);

/// What finishes the picture that is compared with a still: the other side alone.
FrameSettings beside_stills(const FrameInputs& inputs, const FrameSettings& settings);

/// Makes the stills as large as the finished picture.
void fit_stills(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                FrameHandles& handles);

/// Puts the comparison with the stills in place of handles.output, and, where a view of the picture
/// `is_viewed`, of what that is made from.
void compare_with_stills(Graph& graph, const FrameSettings& settings, bool is_viewed,
                         FrameHandles& handles);

} // namespace preview
