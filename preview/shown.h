// What the command line gives to render: a built-in scene or a picture, on the GPU.
#pragma once

#include "preview/frame.h"

#include <optional>
#include <string>

namespace preview {

/// With everything that must outlive its frames.
struct Shown {
    std::string name;
    std::optional<Scene> scene;
    std::optional<GpuScene> gpu_scene;
    std::optional<GpuPicture> picture;
    Size picture_size; ///< {} for a scene

    FrameInputs inputs() const;
    /// The picture's codes are for a display already.
    bool display_encoded() const { return picture && picture->display_encoded; }
};

/// A row of scenes() as it stands at `seconds`, else a picture file. Throws lutlib::Error, and
/// UsageError for what is neither.
Shown load_shown(const gpu::Device& device, const std::string& input, double seconds);

} // namespace preview
