#include "lutlib/error.h"
#include "lutlib/io/look.h"
#include "preview/cli/look_options.h"
#include "preview/cli/modes.h"
#include "preview/cli/picture_file.h"
#include "preview/editor/commands.h"
#include "preview/editor/kept_cameras.h"
#include "preview/editor/stills.h"
#include "preview/frame/shown.h"
#include "preview/window/app.h"
#include "preview/window/opening.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace preview {

namespace {

void open_looks(editor::State& state, const Options& options) {
    const lutlib::io::LookOptions a{.encodings = use_a(options, true).encodings};
    const lutlib::io::LookOptions b{.encodings = use_b(options, true).encodings};
    const bool only_a = options.look_b.empty();
    const std::string& on_recipe = only_a ? options.look_a : options.look_b;
    if (on_recipe != "none") {
        const lutlib::io::LookOptions& own = only_a ? a : b;
        editor::open_look(state, lutlib::io::Look::open(on_recipe, own), own.encodings);
    }
    if (!only_a && options.look_a != "none") {
        editor::open_side(state.sides[0], lutlib::io::Look::open(options.look_a, a), a.encodings);
    }
}

/// Of --watch-engine-folder.
void require_writable_folder(const std::string& path) {
    std::error_code unknown;
    if (!std::filesystem::is_directory(path, unknown)) {
        throw lutlib::Error("make the engine's folder first, or name another: there is none here",
                            {path, 0, {}});
    }
    if (::access(path.c_str(), W_OK | X_OK) != 0) {
        throw lutlib::Error("name a folder in which you may write with --watch-engine-folder: " +
                                std::generic_category().message(errno),
                            {path, 0, {}});
    }
}

editor::State opening_state(const Options& options, const FrameSettings& given,
                            const std::shared_ptr<const Shown>& shown) {
    editor::State state = editor::initial_state();
    const Compare* const usual = state.compare;
    static_cast<PictureSettings&>(state) = given;
    if (!options.is_compare_given) {
        state.compare = usual;
    }
    if (given.scope != nullptr) {
        state.scopes_seen.seen[index_of(*given.scope)] = true;
    }
    state.scopes_seen.side = given.scope_side;
    state.scopes_seen.region = given.scope_region;
    state.scopes_seen.logarithmic = given.scope_logarithmic;
    state.scopes_seen.gain = given.scope_gain;
    state.scopes_seen.encoding = given.scope_levels.encoding;
    take_shown(state, shown);
    state.effects = given.effects;
    state.tonemap = given.tonemap;
    state.bloom = given.bloom;
    state.lights = lights_of(options, shown->scene);
    if (shown->scene) {
        state.orbit = orbit_of(options, *shown->scene, &editor::cameras_kept_of);
        state.surroundings = surroundings_of(options, *shown->scene);
    }
    for (std::size_t i = 0; i < state.sides.size(); ++i) {
        const GpuLookup* const lookup = lookup_of(i == 0 ? options.engine_a : options.engine_b);
        if (lookup != nullptr && lookup->engine != nullptr) {
            state.sides[i].engine = lookup;
        }
    }
    state.picture = picture_codes(options, !shown->display_encoded());
    open_looks(state, options);
    const auto stills = stills_of(options);
    for (std::size_t i = 0; i < stills.size(); ++i) {
        if (stills[i]) {
            editor::show_still(state, i, stills[i]);
        }
    }
    return state;
}

/// As without a window, of the file's usual depth.
std::vector<std::string> save_picture(const gpu::Device& device, const FrameInputs& inputs,
                                      const FrameSettings& settings, const Shown& shown,
                                      const std::string& path) {
    const FileFormat format = file_format(path, "");
    FrameSettings saved = settings;
    saved.format = format.frame_format();
    Executor executor(device, 1);
    const Rendered rendered = render_frame(executor, inputs, saved);
    const bool has_alpha = shown.picture && saved.compare != &compare_difference;
    return write_picture(path, rendered, format, Content::codes,
                         has_alpha ? alpha_for(*shown.picture, rendered.size)
                                   : std::vector<float>());
}

} // namespace

void open_window(const Options& options) {
    WindowSetup setup;
    setup.opened = Following::Clock::now();
    setup.engine_folder = options.engine_folder;
    if (is_given(options, "--watch-engine-folder")) {
        require_writable_folder(options.engine_folder);
    }
    const auto shown = std::make_shared<const Shown>(shown_of(options));
    const FrameSettings given = settings_of(options, shown->picture_size());
    setup.frame.shadow_size = given.shadow_size;
    setup.frame.force_all = given.force_all;
    setup.frame.keeps_light = true;
    setup.frame.dithers = options.dither.value_or(true);
    setup.state = opening_state(options, given, shown);
    setup.display_white = given.scope_levels.white;
    setup.raster = options.raster;
    if (!options.size.empty()) {
        setup.size = settings_of(options, {}).output;
    }
    setup.save_picture = &save_picture;
    setup.device = options.device;
    setup.validation = options.validate;
    setup.font = options.font;
    setup.places = options.places;
    run_window(std::move(setup));
}

} // namespace preview
