// The window: the scene or picture, two looks, and the panels to author one.
#pragma once

#include "preview/editor/model.h"
#include "preview/frame/settings.h"
#include "preview/gpu/size.h"
#include "preview/window/following.h"

#include <optional>
#include <string>

namespace preview {

/// What a window opens with, and what no panel changes.
struct WindowSetup {
    editor::State state;                             ///< with something to show
    FrameSettings frame;                             ///< shadow maps, and what is left out
    const RasterChoice* raster = &rasters().front(); ///< who rasterises
    std::optional<Size> size;  ///< of the window; empty: as it was, or fits the monitor
    std::string device;        ///< as gpu::DeviceOptions::wanted
    bool validation = false;   ///< under Vulkan's validation layers
    std::string font;          ///< TrueType or OpenType file
    std::string engine_folder; ///< where strips go at the press of a key; empty: nobody named one
    Following::Clock::time_point opened{}; ///< before all that is shown was read
    std::string places; ///< file that tells where the controls are; empty: nobody asks
};

/// Runs until the window is closed. Redraws on input, on new looks and on nothing else. Throws
/// lutlib::Error when no window can be had.
void run_window(WindowSetup setup);

} // namespace preview
