// A frame of the window: its settings from what a person has chosen, and what finished frames tell
// the panels and the next frame.
#pragma once

#include "preview/frame/frame.h"
#include "preview/frame/shown.h"
#include "preview/graph/execute.h"
#include "preview/panels/ui.h"

#include <optional>

namespace preview {

/// The picture's part of a window of that size, in its pixels.
vk::Rect2D output_area(const panels::Rect& area, vk::Extent2D window);

using ScopeAreas = std::array<vk::Rect2D, scopes.size()>;
/// The scopes' parts of a window of that size, in its pixels; empty for one that is not seen.
ScopeAreas scope_areas(const panels::Ui& ui, vk::Extent2D window);

/// `given` with what a person has chosen, for a frame of that size; no scope has a size yet.
FrameSettings window_settings(const panels::Ui& ui, FrameSettings given, Size output);

/// Reads measurements of finished frames, without waiting for any.
class FrameReader {
  public:
    /// `frames` are in flight at once.
    explicit FrameReader(int frames) : frames_in_flight_(frames) {}

    /// Another scene or picture is shown: what was measured holds no longer.
    void forget();
    /// The largest value of the HDR picture that a frame with these settings has, when frames of
    /// the same light have measured it.
    std::optional<float> hdr_maximum_for(const FrameSettings& settings,
                                         const std::vector<PointLight>& lights,
                                         const Surroundings& surroundings);
    /// After a frame was submitted, with the handles that build_frame() gave. Whether there are new
    /// measurements, which a further frame shows.
    bool read(Executor& executor, const Graph& graph, const FrameHandles& handles, panels::Ui& ui);

  private:
    int frames_in_flight_;
    FrameSettings measured_for_; ///< of the light in the newest frames
    std::vector<PointLight> lights_;
    Surroundings surroundings_;
    int frames_of_light_ = 0; ///< how many of those frames there are
    std::optional<float> hdr_maximum_;
};

} // namespace preview
