#include "preview/cli/studied_input.h"

#include "preview/cli/look_options.h"
#include "preview/editor/kept_cameras.h"
#include "preview/look/look_file.h"

#include <memory>

namespace preview {

namespace {

std::optional<GpuLook> studied_look(const gpu::Device& device, const std::string& path,
                                    const LookUse& use) {
    const LoadedLook look = load_look(path, use);
    return look.skip_reason.empty() ? std::optional<GpuLook>(std::in_place, device, look.data)
                                    : std::nullopt;
}

} // namespace

Situation situation_of(const Options& options, const gpu::Device& device) {
    Situation out;
    out.shown = std::make_shared<const Shown>(shown_of(options));
    out.settings = settings_of(options, out.shown->picture_size());
    out.settings.raster =
        options.raster->on(device, picture_size(out.settings.output, *out.settings.compare));
    out.lights = lights_of(options, out.shown->scene);
    if (out.shown->scene) {
        out.settings.orbit = orbit_of(options, *out.shown->scene, &editor::cameras_kept_of);
        out.surroundings = surroundings_of(options, *out.shown->scene);
    }
    return out;
}

StudiedLooks::StudiedLooks(const gpu::Device& device, const Options& options, bool has_light)
    : a(studied_look(device, options.look_a, use_a(options, has_light))),
      b(studied_look(device, options.look_b, use_b(options, has_light))) {}

void StudiedLooks::put_into(Situation& situation) const {
    situation.look_a = a ? &*a : nullptr;
    situation.look_b = b ? &*b : nullptr;
}

} // namespace preview
