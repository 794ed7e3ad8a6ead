#include "preview/cli/rendering.h"

#include "lutlib/io/file.h"
#include "lutlib/io/output_names.h"
#include "lutlib/io/references.h"
#include "lutlib/io/terminal.h"
#include "preview/cli/look_options.h"
#include "preview/editor/kept_cameras.h"
#include "preview/finish/fit.h"
#include "preview/finish/scope_csv.h"
#include "preview/look/look_file.h"
#include "preview/scene/gpu_scene.h"
#include "preview/scene/nearest.h"

#include <cmath>

namespace preview {

namespace {

std::optional<GpuLook> load_side(const gpu::Device& device, const std::string& path,
                                 const LookUse& use, bool force, std::string& notes,
                                 const char* side, std::string& reason, lutlib::Encoding& shown) {
    const LoadedLook look = load_look(path, use);
    shown = look.shown;
    const std::string name = "look " + std::string(side) + ": ";
    for (const std::string& line : look.told) {
        tell(path + ": " + line);
        notes += name + line + "\n";
    }
    for (const std::string& line : {look.encodings, look.note}) {
        if (!line.empty() && (look.told.empty() || look.told.back() != line)) {
            notes += name + line + "\n";
        }
    }
    if (look.skip_reason.empty() || (force && path != "none" && !path.empty())) {
        return std::optional<GpuLook>(std::in_place, device, look.data);
    }
    reason = look.skip_reason;
    return std::nullopt;
}

gpu::DeviceOptions device_options_of(const Options& options) {
    gpu::DeviceOptions out;
    out.wanted = options.device;
    out.validation = options.validate;
    return out;
}

void tell_lost(const std::string& path, const std::vector<std::string>& lost) {
    for (const std::string& what : lost) {
        tell(path + ": not written, as the file does not hold it: " + what);
    }
}

} // namespace

void tell(const std::string& line) {
    lutlib::io::print_err("lutpreview: " + lutlib::io::shown_text(line) + "\n");
}

void refuse_looks_as_output(const Options& options) {
    for (const std::string& look : {options.look_a, options.look_b}) {
        lutlib::io::require_another_than(look, "a look that is shown", options.output);
    }
}

Rendering::Rendering(const Options& options)
    : device(device_options_of(options)), shown(std::make_shared<const Shown>(shown_of(options))),
      settings(settings_of(options, shown->picture_size())),
      lights(lights_of(options, shown->scene)), on_gpu(device, shown) {
    for (const std::string& line : shown->left_out) {
        notes += "left out  of " + shown->name + ": " + line + "\n";
        if (!options.explain) {
            tell(shown->name + ": not supported, left out: " + line);
        }
    }
    if (shown->scene) {
        settings.orbit = orbit_of(options, *shown->scene, &editor::cameras_kept_of);
        surroundings = surroundings_of(options, *shown->scene);
    }
    unused = unused_options(
        options, {shown->scene ? &*shown->scene : nullptr, shown->display_encoded()}, settings);
    for (const std::string& line : unused) {
        tell(line);
    }
    settings.raster = options.raster->on(device, picture_size(settings.output, *settings.compare));
    for (const std::string& line : shown->told) {
        notes += line + "\n";
        tell(line);
    }
    if (!options.output.empty()) {
        refuse_looks_as_output(options);
        for (const std::string& read : shown->files) {
            lutlib::io::require_another_than(read, "what is shown", options.output);
        }
        if (writes_counts(options)) {
            settings.keeps_scopes = true;
        } else {
            file = file_format(options.output, options.depth);
        }
        for (const std::string& line : shown->not_written) {
            tell(shown->name + ": not written: " + line + "; 'lutconv apply' keeps it");
        }
    }
    const bool shows_picture = !settings.shows_intermediate() && settings.scope == nullptr;
    settings.keep_hdr =
        file.holds_light && options.exr_light && shows_picture && !shown->display_encoded();
    if (const std::string line = not_in_light(options, settings);
        settings.keep_hdr && !line.empty()) {
        tell(line);
    }
    // Scopes count the picture in 8 bits.
    settings.format = settings.scope != nullptr ? Format::rgba8 : file.frame_format();
    settings.keeps_light = true; // measuring it draws it already
    settings.dithers = options.dither.value_or(false);
    settings.shows_numbers = file.holds_light && settings.shows_intermediate();
    const bool force = options.frame.force_all, has_light = !shown->display_encoded();
    std::array<lutlib::Encoding, 2> codes;
    look_a = load_side(device, options.look_a, use_a(options, has_light), force, notes, "A",
                       no_look[0], codes[0]);
    names = {look_title(options.look_a), look_title(options.look_b)};
    take_stills(options);
    look_b = load_side(device, options.look_b, use_b(options, has_light), force, notes, "B",
                       no_look[1], codes[1]);
    name_levels(codes);
}

void Rendering::name_levels(const std::array<lutlib::Encoding, 2>& codes) {
    ScopeLevels& levels = settings.scope_levels;
    const auto known = shown_codes(*settings.scope_side, *settings.compare, codes);
    levels.shown = known.value_or(lutlib::srgb());
    if (settings.scope == nullptr || !has_levels(*settings.scope)) {
        return;
    }
    notes += "scope     " + levels_text(levels) + "\n";
    if (levels.encoding && !known) {
        tell("--scope-side: " + mixed_codes_text(codes));
    }
}

void Rendering::take_stills(const Options& options) {
    const auto loaded = stills_of(options);
    const Size picture =
        shown->picture ? shown->picture->size : picture_size(settings.output, *settings.compare);
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        if (!loaded[i]) {
            continue;
        }
        const Still& still = *loaded[i];
        std::vector<std::string> lines{still.shown_as};
        if (std::string fit = fit_text(still.size, picture); !fit.empty()) {
            lines.push_back(std::move(fit));
        }
        lines.insert(lines.end(), still.told.begin(), still.told.end());
        for (const std::string& line : lines) {
            tell(still.path + ": " + line);
            notes += (i == 0 ? "still A: " : "still B: ") + line + "\n";
        }
        if (!options.output.empty()) {
            lutlib::io::require_another_than(still.path, "a still that is shown", options.output);
        }
        names[i] = "still " + title_of(still);
        stills[i].emplace(device, still.size, still.rgba, true);
    }
}

FrameInputs Rendering::inputs() const {
    FrameInputs out = on_gpu.inputs();
    out.lights = &lights;
    out.surroundings = &surroundings;
    out.look_a = look_a ? &*look_a : nullptr;
    out.look_b = look_b ? &*look_b : nullptr;
    for (std::size_t i = 0; i < stills.size(); ++i) {
        out.stills[i] = stills[i] ? &*stills[i] : nullptr;
    }
    out.no_look = {no_look[0], no_look[1]};
    out.names = {names[0], names[1]};
    return out;
}

void tell_empty_view(const Rendering& rendering) {
    const FrameInputs inputs = rendering.inputs();
    if (inputs.scene == nullptr) {
        return;
    }
    const Size size = picture_size(rendering.settings.output, *rendering.settings.compare);
    const Orbit& orbit = rendering.settings.orbit;
    const Camera camera =
        camera_of(orbit, static_cast<float>(size.width) / static_cast<float>(size.height));
    if (std::isinf(nearest_depth(*inputs.scene, inputs.gpu_scene->geometry,
                                 camera.projection * camera.view, orbit.near_plane))) {
        tell("the camera sees nothing of " + rendering.shown->name +
             ": turn it by --azimuth and --elevation, or name another with --camera");
    }
}

void write_frame(const std::string& path, const Rendering& rendering, const Rendered& rendered) {
    const FrameSettings& settings = rendering.settings;
    if (settings.keeps_scopes) {
        lutlib::io::write_file(
            path, scope_csv(*settings.scope, rendered.scope_counts, settings.scope_levels));
        return;
    }
    const std::optional<ShownPicture>& picture = rendering.shown->picture;
    if (settings.keep_hdr) {
        tell_lost(path, write_light(path, rendered, rendering.file,
                                    picture ? alpha_for(*picture, rendered.hdr_size)
                                            : std::vector<float>()));
        return;
    }
    std::vector<float> alpha;
    if (picture && !settings.shows_intermediate() && settings.scope == nullptr &&
        settings.compare != &compare_difference) {
        alpha = alpha_for(*picture, rendered.size);
    }
    tell_lost(path,
              write_picture(path, rendered, rendering.file,
                            settings.shows_numbers ? Content::numbers : Content::codes, alpha));
}

} // namespace preview
