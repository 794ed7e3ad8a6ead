// The window: the scene or picture, two looks, and the panels to author one.
#pragma once

#include "preview/editor/model.h"
#include "preview/frame/settings.h"
#include "preview/frame/shown.h"
#include "preview/gpu/device.h"
#include "preview/gpu/size.h"
#include "preview/window/following.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace preview {

/// Renders a frame and writes it as the file's name says. The answer is what of it the file does
/// not hold, a phrase each. Throws lutlib::Error.
using SavePicture = std::function<std::vector<std::string>(
    const gpu::Device& device, const FrameInputs& inputs, const FrameSettings& settings,
    const Shown& shown, const std::string& path)>;

/// What a window opens with, and what no panel changes.
struct WindowSetup {
    editor::State state;                             ///< with something to show
    FrameSettings frame;                             ///< shadow maps, and what is left out
    const RasterChoice* raster = &rasters().front(); ///< who rasterises
    std::optional<Size> size; ///< of the window; empty: as it was, or fits the monitor
    std::string device;       ///< as gpu::DeviceOptions::wanted
    float display_white = usual_display_white; ///< cd/m2, for which luminances are told
    bool validation = false;                   ///< under Vulkan's validation layers
    std::string font;                          ///< TrueType or OpenType file
    std::string engine_folder; ///< where strips go at the press of a key; empty: nobody named one
    Following::Clock::time_point opened{}; ///< before all that is shown was read
    SavePicture save_picture;              ///< by who knows files of pictures
    std::string places; ///< file that tells where the controls are; empty: nobody asks
};

/// Runs until the window is closed. Redraws on input, on new looks and on nothing else. Throws
/// lutlib::Error when no window can be had.
void run_window(WindowSetup setup);

} // namespace preview
