// What frames without a window are rendered from, and where they go.
#pragma once

#include "preview/cli/headless.h"
#include "preview/cli/options.h"
#include "preview/cli/picture_file.h"
#include "preview/frame/shown.h"
#include "preview/look/gpu_look.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace preview {

/// A line on standard error.
void tell(const std::string& line);

struct Rendering {
    /// Tells what the files lost and what of the options changes nothing. Throws lutlib::Error, and
    /// UsageError for an output that is read.
    explicit Rendering(const Options& options);
    FrameInputs inputs() const;

    gpu::Device device;
    std::shared_ptr<const Shown> shown;
    FrameSettings settings;
    std::vector<PointLight> lights;
    Surroundings surroundings;
    FileFormat file;
    std::string notes; ///< lines of --explain: what the files have and the frame has not
    std::vector<std::string> unused;    ///< what was told of options that change nothing
    std::array<std::string, 2> no_look; ///< why a side has none
    std::array<std::string, 2> names;   ///< of the sides
    std::optional<GpuLook> look_a, look_b;
    std::array<std::optional<GpuPicture>, 2> stills;
    GpuShown on_gpu;

  private:
    /// What the scope's levels are, where the sides' codes are these.
    void name_levels(const std::array<lutlib::Encoding, 2>& codes);
    void take_stills(const Options& options);
};

/// Throws lutlib::UsageError when the output is one of the looks.
void refuse_looks_as_output(const Options& options);

/// Says so when the camera sees nothing of the scene.
void tell_empty_view(const Rendering& rendering);

/// The picture or its light, as the file keeps it; tells what it cannot hold. Throws lutlib::Error.
void write_frame(const std::string& path, const Rendering& rendering, const Rendered& rendered);

} // namespace preview
