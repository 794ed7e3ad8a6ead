#include "preview/shown.h"

#include "lutlib/error.h"
#include "lutlib/io/image.h"

#include <filesystem>

namespace preview {

FrameInputs Shown::inputs() const {
    FrameInputs out;
    out.scene = scene ? &*scene : nullptr;
    out.gpu_scene = gpu_scene ? &*gpu_scene : nullptr;
    out.picture = picture ? &*picture : nullptr;
    return out;
}

Shown load_shown(const gpu::Device& device, const std::string& input, double seconds) {
    Shown shown;
    shown.name = input;
    if (const SceneInfo* info = scene_named(input)) {
        shown.scene = scene_at(*info, seconds);
        shown.gpu_scene.emplace(device, *shown.scene);
        return shown;
    }
    if (!std::filesystem::exists(input)) {
        std::string names;
        for (const SceneInfo& info : scenes())
            names += (names.empty() ? "" : ", ") + std::string(info.name);
        throw lutlib::UsageError("'" + input +
                                 "' is neither a picture file nor a scene; scenes are: " + names);
    }
    const lutlib::io::FloatImage image = lutlib::io::read_image(input);
    shown.picture_size = {static_cast<std::uint32_t>(image.width),
                          static_cast<std::uint32_t>(image.height)};
    shown.picture.emplace(device, shown.picture_size, image.rgba,
                          lutlib::io::info_of(image.depth).integer);
    return shown;
}

} // namespace preview
