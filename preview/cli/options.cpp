#include "preview/cli/options.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "preview/cli/light_edit.h"
#include "preview/effects/effect.h"
#include "preview/frame/usual_finish.h"
#include "preview/passes/resolve.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace preview {

namespace {

constexpr std::uint32_t largest_side = 16384;

constexpr Study study_rows[] = {
    {"check", "runs every pass with extreme inputs and says where numbers go bad"},
    {"report", "measures what every pass's settings cost in error and time, and writes a page",
     true},
};

/// Switches off a part of the frame or takes out an effect.
void leave_out(FrameSettings& settings, const std::string& name) {
    if (const EffectInfo* const part = lutlib::find_named(effects, name)) {
        settings.without.set(part->effect, true);
        return;
    }
    if (const PostEffect* const effect = post_effect_named(name)) {
        take_out(settings.effects, *effect);
        return;
    }
    std::vector<std::string_view> names = lutlib::name_list(effects);
    const std::vector<std::string_view> more = lutlib::name_list(post_effects());
    names.insert(names.end(), more.begin(), more.end());
    lutlib::refuse_name("effect or part of the frame", name, names);
}

EffectUses effects_of(const Options& options, bool is_scene) {
    EffectUses uses;
    set_usual(uses, options.fxaa.value_or(is_scene && usual_finish(options.input).is_antialiased));
    for (const EffectUse& use : options.effects) {
        put_use(uses, use);
    }
    return uses;
}

/// Puts the effect in use, with its focus on that texel of one side's picture.
void focus_at(EffectUses& uses, const std::string& text, Size size) {
    const ProbePlace place = parse_place("--focus-at", text, size);
    const PostEffect& effect = *post_effect_named("depth-of-field");
    const EffectUse usual = usual_use(effect);
    const EffectUse* const given = use_of(uses, effect);
    EffectUse use = given != nullptr ? *given : usual;
    for (const std::string_view parameter : {"focus", "at-x", "at-y"}) {
        const lutlib::Parameter* const row = lutlib::find_named(effect.parameters, parameter);
        const auto i = static_cast<std::size_t>(row - effect.parameters.data());
        if (use.values[i] != usual.values[i]) {
            throw lutlib::UsageError(fmt::format("--focus-at and --effect {}:{}=... both say where "
                                                 "the focus is: drop one of them",
                                                 effect.name, parameter));
        }
    }
    const auto share = [](int texel, std::uint32_t length) { return (texel + 0.5) / length; };
    set_number(use, "focus", 0);
    set_number(use, "at-x", share(place.x, size.width));
    set_number(use, "at-y", share(place.y, size.height));
    put_use(uses, std::move(use));
}

/// The output's size: as asked for, and of a picture's proportions.
Size output_size(const Options& options, const FrameSettings& settings, Size input_size) {
    const bool is_picture = input_size != Size{};
    Size size = is_picture ? input_size : settings.output;
    if (!options.size.empty()) {
        size = parse_size("--size", options.size);
        if (is_picture) {
            size = fitted(input_size, picture_size(size, *settings.compare));
        }
    }
    if (is_picture && settings.compare == &compare_side) {
        size.width *= 2;
    }
    return size;
}

/// Reads two numbers with `between` between them and nothing else.
template <class T>
bool reads_pair(const std::string& text, char between, T& first, T& second) {
    const char* const end = text.data() + text.size();
    const auto one = std::from_chars(text.data(), end, first);
    if (one.ec != std::errc{} || one.ptr == end || *one.ptr != between) {
        return false;
    }
    const auto two = std::from_chars(one.ptr + 1, end, second);
    return two.ec == std::errc{} && two.ptr == end;
}
} // namespace
std::span<const Study> studies() {
    return study_rows;
}

double reach_of(const NumberRow<Orbit>& row) {
    return row.max - row.min;
}

Size parse_size(std::string_view option, const std::string& text) {
    Size size;
    if (reads_pair(text, 'x', size.width, size.height) && size.width > 0 && size.height > 0 &&
        size.width <= largest_side && size.height <= largest_side) {
        return size;
    }
    throw lutlib::UsageError(fmt::format("{} needs WIDTHxHEIGHT with sides of 1 to {}, got '{}'",
                                         option, largest_side, text));
}

lutlib::Encoding encoding_of(const std::string& name, const std::string& flag) {
    try {
        return lutlib::require_encoding(name);
    } catch (const lutlib::UsageError& error) {
        throw lutlib::UsageError(flag + ": " + error.message());
    }
}

ProbePlace parse_place(std::string_view option, const std::string& text, Size picture) {
    ProbePlace place;
    if (reads_pair(text, ',', place.x, place.y) && place.x >= 0 && place.y >= 0 &&
        static_cast<std::uint32_t>(place.x) < picture.width &&
        static_cast<std::uint32_t>(place.y) < picture.height) {
        return place;
    }
    throw lutlib::UsageError(fmt::format("{} needs X,Y within the picture of {}x{}, got '{}'",
                                         option, picture.width, picture.height, text));
}

ScopeRegion parse_region(std::string_view option, const std::string& text, Size picture) {
    std::array<std::uint32_t, 4> n{}; // x, y, width, height
    const std::size_t comma = text.find(',', text.find(',') + 1);
    const bool is_read = comma != std::string::npos &&
                         reads_pair(text.substr(0, comma), ',', n[0], n[1]) &&
                         reads_pair(text.substr(comma + 1), ',', n[2], n[3]);
    if (!is_read || n[2] == 0 || n[3] == 0 || std::uint64_t{n[0]} + n[2] > picture.width ||
        std::uint64_t{n[1]} + n[3] > picture.height) {
        throw lutlib::UsageError(
            fmt::format("{} needs X,Y,WIDTH,HEIGHT within the picture of {}x{}, got '{}'", option,
                        picture.width, picture.height, text));
    }
    const auto share = [](std::uint32_t texels, std::uint32_t length) {
        return static_cast<float>(texels) / static_cast<float>(length);
    };
    return {share(n[0], picture.width), share(n[1], picture.height), share(n[2], picture.width),
            share(n[3], picture.height)};
}

bool is_given(const Options& options, const std::string& flag) {
    return std::find(options.given.begin(), options.given.end(), flag) != options.given.end();
}

bool opens_window(const Options& options) {
    return options.study == nullptr && !options.headless && !options.explain && !options.timings &&
           !options.list && options.probe.empty() && options.output.empty() &&
           options.cube_view.empty();
}

bool shows_stills(const Options& options) {
    return !options.still_a.empty() || !options.still_b.empty();
}

const Compare* compare_of(const Options& options) {
    return options.is_compare_given                           ? options.frame.compare
           : options.look_b.empty() && !shows_stills(options) ? &compare_a
                                                              : &compare_split;
}

FrameSettings settings_of(const Options& options, Size input_size) {
    FrameSettings settings = options.frame;
    settings.compare = compare_of(options);
    const UsualFinish usual = usual_finish(options.input);
    if (!options.is_tonemap_given) {
        settings.tonemap = usual.tonemap;
    }
    if (!options.is_bloom_given) {
        settings.bloom = usual.bloom;
    }
    if (settings.scope != nullptr) {
        settings.scope_sizes[index_of(*settings.scope)] =
            options.scope_size.empty() ? Size{settings.scope->width, settings.scope->height}
                                       : parse_size("--scope-size", options.scope_size);
    }
    if (!options.scope_encoding.empty()) {
        settings.scope_levels.encoding = encoding_of(options.scope_encoding, "--scope-encoding");
    }
    settings.scope_levels.white = static_cast<float>(options.display_white);
    settings.effects = effects_of(options, input_size == Size{});
    settings.seconds = options.seconds;
    settings.output = output_size(options, settings, input_size);
    if (!options.focus_at.empty()) {
        focus_at(settings.effects, options.focus_at,
                 picture_size(settings.output, *settings.compare));
    }
    if (!options.scope_region.empty()) {
        settings.scope_region = parse_region("--scope-region", options.scope_region,
                                             picture_size(settings.output, *settings.compare));
    }
    for (const std::string& name : options.without) {
        leave_out(settings, name);
    }
    if (!options.probe.empty()) {
        settings.probe = parse_place("--probe", options.probe, settings.output);
    }
    if (settings.probe && settings.shows_intermediate()) {
        throw lutlib::UsageError("--probe reads the finished picture, which --debug-view does not "
                                 "make: drop one of them");
    }
    return settings;
}

std::vector<PointLight> lights_of(const Options& options, const std::optional<Scene>& scene) {
    std::vector<PointLight> lights = scene ? scene->lights : std::vector<PointLight>();
    for (const std::string& text : options.lights) {
        edit_light(lights, text);
    }
    return lights;
}

std::string surroundings_file(const Options& options) {
    const bool is_kind = lutlib::find_named(surroundings_kinds(), options.surroundings) != nullptr;
    return is_kind ? std::string() : options.surroundings;
}

Surroundings surroundings_of(const Options& options, const Scene& scene) {
    Surroundings out = scene.surroundings;
    if (const SurroundingsInfo* const row =
            lutlib::find_named(surroundings_kinds(), options.surroundings)) {
        out.kind = row->kind;
    } else if (!options.surroundings.empty()) {
        out.kind = SurroundingsKind::picture;
    }
    if (out.kind == SurroundingsKind::picture && surroundings_file(options).empty()) {
        throw lutlib::UsageError("--surroundings picture: name the picture's file in its place");
    }
    for (std::size_t i = 0; i < options.surroundings_numbers.size(); ++i) {
        if (options.surroundings_numbers[i]) {
            surroundings_numbers()[i].of(out) = *options.surroundings_numbers[i];
        }
    }
    out.seconds = options.seconds;
    return out;
}

namespace {

using CamerasOf = std::vector<NamedCamera> (*)(const std::string& input);

const NamedCamera* camera_named(const std::vector<NamedCamera>& cameras, const std::string& name) {
    const auto found = std::find_if(cameras.begin(), cameras.end(),
                                    [&](const NamedCamera& row) { return row.name == name; });
    return found != cameras.end() ? &*found : nullptr;
}

Orbit named_camera(const Options& options, const Scene& scene, CamerasOf kept) {
    if (const auto* const own = camera_named(scene.cameras, options.camera_name)) {
        return own->orbit;
    }
    const std::vector<NamedCamera> others = kept(options.input);
    if (const auto* const other = camera_named(others, options.camera_name)) {
        return other->orbit;
    }
    std::vector<std::string_view> names;
    for (const std::vector<NamedCamera>* const list : {&scene.cameras, &others}) {
        for (const NamedCamera& camera : *list) {
            names.push_back(camera.name);
        }
    }
    if (names.empty()) {
        throw lutlib::UsageError("--camera: '" + options.input +
                                 "' has no cameras; keep one in the window's panel Scene");
    }
    lutlib::refuse_name("camera", options.camera_name, names);
}

} // namespace

Orbit orbit_of(const Options& options, const Scene& scene, CamerasOf kept) {
    Orbit orbit = options.camera_name.empty() ? scene.orbit : named_camera(options, scene, kept);
    for (std::size_t i = 0; i < options.camera.size(); ++i) {
        camera_numbers()[i].of(orbit) += options.camera[i];
    }
    return orbit;
}
} // namespace preview
