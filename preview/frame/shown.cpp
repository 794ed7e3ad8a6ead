#include "preview/frame/shown.h"

#include "lutlib/error.h"
#include "lutlib/io/image.h"
#include "preview/scene/import.h"

#include <filesystem>

namespace preview {

namespace {

ShownPicture load_picture(const std::string& path) {
    lutlib::io::FloatImage image = lutlib::io::read_image(path);
    return {{static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height)},
            std::move(image.rgba),
            lutlib::io::info_of(image.depth).integer};
}

} // namespace

Shown load_shown(const std::string& input, double seconds) {
    Shown shown;
    shown.name = input;
    if (const SceneInfo* info = scene_named(input)) {
        shown.scene = scene_at(*info, seconds);
        return shown;
    }
    if (!std::filesystem::exists(input)) {
        std::string names;
        for (const SceneInfo& info : scenes()) {
            names += (names.empty() ? "" : ", ") + std::string(info.name);
        }
        throw lutlib::UsageError("'" + input +
                                 "' is neither a file nor a scene; scenes are: " + names);
    }
    if (is_model_file(input)) {
        ImportedScene imported = import_scene(input);
        shown.scene = std::move(imported.scene);
        shown.left_out = std::move(imported.left_out);
    } else {
        shown.picture = load_picture(input);
    }
    return shown;
}

GpuShown::GpuShown(const gpu::Device& device, std::shared_ptr<const Shown> shown)
    : shown_(std::move(shown)) {
    if (shown_->scene) {
        scene_.emplace(device, *shown_->scene);
    }
    if (shown_->picture) {
        picture_.emplace(device, shown_->picture->size, shown_->picture->rgba,
                         shown_->picture->display_encoded);
    }
}

FrameInputs GpuShown::inputs() const {
    FrameInputs out;
    out.scene = shown_->scene ? &*shown_->scene : nullptr;
    out.gpu_scene = scene_ ? &*scene_ : nullptr;
    out.picture = picture_ ? &*picture_ : nullptr;
    return out;
}

} // namespace preview
