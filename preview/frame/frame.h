// One frame, from the scene to the finished picture: all its wiring is build_frame().
//
// What the scene or the settings do not need is left out: build_frame() withholds it and says why,
// and the graph drops every pass whose result nobody reads.
#pragma once

#include "preview/frame/settings.h"
#include "preview/passes/geometry_view.h"
#include "preview/passes/view.h"

#include <span>
#include <string_view>

namespace preview {

/// An intermediate that can be shown, and how.
struct DebugView {
    std::string_view name;
    std::string_view help;
    ImageHandle (*handle)(const FrameHandles& handles);
    View view;
    const GeometryView* geometry = nullptr; ///< drawn for this view alone, into handles.geometry
    bool counts_lights = false; ///< counted for this view alone, into handles.light_counts
};
std::span<const DebugView> debug_views();
const DebugView* debug_view_named(std::string_view name);

/// Declares the frame. Presents the output, the HDR maximum, the figures of a difference and what
/// the settings keep; with a debug view the output alone. Throws lutlib::UsageError for a view of
/// something that this frame withholds.
FrameHandles build_frame(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings);

} // namespace preview
