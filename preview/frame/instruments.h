// What a frame tells of its colours beside the picture: the scopes, the probe, and the counts along
// the curves' axes. A part of build_frame().
#pragma once

#include "preview/frame/settings.h"
#include "preview/passes/finish.h"

namespace preview {

/// Declares and presents what the settings ask for, of the picture handles.output and of what the
/// finishing pass had, whose texel `probe` is settings.probe in a picture of which all is seen or a
/// part. With FrameSettings::scope that scope becomes the output. Throws
/// lutlib::UsageError for one that this frame has nothing for.
void add_instruments(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                     const Finishing& finishing, std::optional<ProbePlace> probe,
                     FrameHandles& handles);

} // namespace preview
