// What there is to render: a scene or a picture, from the command line or a file, as plain data;
// and its part on the GPU.
#pragma once

#include "preview/frame/settings.h"
#include "preview/gpu/size.h"
#include "preview/scene/gpu_scene.h"
#include "preview/scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace preview {

struct ShownPicture {
    Size size;
    std::vector<float> rgba;      ///< rows from the top
    bool display_encoded = false; ///< its codes are for a display already
    bool has_alpha = false;       ///< the file stores it
};

/// One of both.
struct Shown {
    std::string name;
    std::optional<Scene> scene;
    std::optional<ShownPicture> picture;
    std::optional<ShownPicture> surroundings; ///< a picture of all directions about the scene
    double seconds = 0;                       ///< at which a built-in scene stands
    std::string surroundings_file;            ///< where its picture lies
    std::vector<std::string> files;           ///< that all of it was read from
    std::vector<std::string> left_out; ///< what its file has and the scene has not, with counts
    std::vector<std::string> told;     ///< what was made of pictures' colours: "FILE: ..." each
    /// What a picture's file holds and no file written here does, a phrase each.
    std::vector<std::string> not_written;

    bool display_encoded() const { return picture && picture->display_encoded; }
    Size picture_size() const { return picture ? picture->size : Size{}; }
};

/// A row of scenes() as it stands at `seconds`, else a model or picture file. Throws lutlib::Error,
/// and UsageError for what is none of them.
Shown load_shown(const std::string& input, double seconds);

/// Reads the picture of what surrounds `shown`, a scene; codes become light by sRGB's curve. Throws
/// lutlib::Error for a file that is no picture, and UsageError for surroundings of a picture.
void load_surroundings(Shown& shown, const std::string& path);

/// What was made of the colours of the picture that surrounds the scene; part of told.
std::vector<std::string> told_of_surroundings(const Shown& shown);

/// The same, by its names alone, as its files have it now. Throws as both of those do.
Shown load_again(const Shown& shown);

/// What must outlive the frames that show it.
class GpuShown {
  public:
    GpuShown(const gpu::Device& device, std::shared_ptr<const Shown> shown);

    const std::shared_ptr<const Shown>& shown() const { return shown_; }
    FrameInputs inputs() const;

  private:
    std::shared_ptr<const Shown> shown_;
    std::optional<GpuScene> scene_;
    std::optional<GpuPicture> picture_, surroundings_;
};

} // namespace preview
