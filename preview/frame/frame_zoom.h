// A frame of which a part is seen, pixel by pixel. A part of build_frame().
#pragma once

#include "preview/frame/settings.h"
#include "preview/graph/graph.h"

#include <optional>

namespace preview {

/// Whether a part of the picture is seen; intermediates and scopes are always seen whole.
bool zooms(const FrameSettings& settings);

/// How large the picture of one side is finished, before any of it is seen.
Size finished_size(const FrameInputs& inputs, const FrameSettings& settings);

/// The texel of a finished picture of that size, of one side, that stands at settings.probe of the
/// output.
std::optional<ProbePlace> probe_place(const FrameInputs& inputs, const FrameSettings& settings,
                                      Size finished);

/// Puts what is seen in place of handles.output, with the marks of its comparison, or, where a view
/// of the picture `is_viewed`, of what that is made from. Returns the border of the
/// comparison in the output.
WipeShape zoom_in(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                  bool is_viewed, FrameHandles& handles);

} // namespace preview
