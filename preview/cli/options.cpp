#include "preview/cli/options.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "preview/cli/light_edit.h"
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/frame/usual_finish.h"
#include "preview/look/cube_settings.h"
#include "preview/look/gpu_lookups.h"
#include "preview/passes/resolve.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <type_traits>

namespace preview {

namespace {

constexpr std::uint32_t largest_side = 16384;

/// A number from low to high; unlike CLI::Range it refuses NaN.
CLI::Validator within(double low, double high) {
    return {[=](std::string& text) {
                double value = 0;
                const bool good =
                    CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
                return good ? std::string()
                            : fmt::format("'{}' is not a number from {} to {}", text, low, high);
            },
            fmt::format("in [{} - {}]", low, high)};
}

void declare(CLI::App& app, const OptionRow& row, Options& options) {
    std::visit(
        [&](auto of) {
            auto& member = of(options);
            using T = std::remove_reference_t<decltype(member)>;
            if constexpr (std::is_same_v<T, bool>) {
                app.add_flag(row.flag, member, row.help);
            } else {
                CLI::Option* const option = app.add_option(row.flag, member, row.help);
                option->capture_default_str();
                if (row.min < row.max) {
                    option->check(within(row.min, row.max));
                }
                if (row.type != nullptr) {
                    option->type_name(row.type);
                }
                if (row.one_of[0] != nullptr) {
                    option->check(CLI::IsMember({row.one_of[0], row.one_of[1]}));
                }
            }
        },
        row.of);
}

template <class S>
void declare(CLI::App& app, const ChoiceRow<S>& row, S& settings) {
    CLI::Option* const option =
        app.add_option_function<std::string>(
               fmt::format("--{}", row.flag),
               [&row, &settings](const std::string& name) {
                   const std::vector<Option> options = row.options();
                   const Option& found = lutlib::require_named(options, row.kind, name);
                   row.choose(settings, static_cast<std::size_t>(&found - options.data()));
               },
               std::string(row.help))
            ->type_name("NAME");
    if (row.chosen != nullptr) {
        option->default_str(std::string(row.options()[row.chosen(settings)].name));
    }
}

template <class S>
void declare(CLI::App& app, std::span<const NumberRow<S>> rows, S& settings) {
    for (const NumberRow<S>& row : rows) {
        CLI::Option* const option =
            app.add_option(fmt::format("--{}", row.flag), row.of(settings), std::string(row.help))
                ->check(within(row.min, row.max));
        // The help of one that stands for something says so.
        if (!row.is_own(settings)) {
            option->default_str(fmt::format("{}", row.value(settings)));
        }
    }
}

/// How far a number may be moved: from any place of its range to any other.
double reach_of(const NumberRow<Orbit>& row) {
    return row.max - row.min;
}

void declare_camera(CLI::App& app, Options& options) {
    for (std::size_t i = 0; i < options.camera.size(); ++i) {
        const NumberRow<Orbit>& row = camera_numbers()[i];
        app.add_option(fmt::format("--{}", row.flag), options.camera[i], std::string(row.help))
            ->check(within(-reach_of(row), reach_of(row)));
    }
}

void declare_surroundings(CLI::App& app, Options& options) {
    for (std::size_t i = 0; i < options.surroundings_numbers.size(); ++i) {
        const NumberRow<Surroundings>& row = surroundings_numbers()[i];
        app.add_option(fmt::format("--{}", row.flag), options.surroundings_numbers[i],
                       std::string(row.help))
            ->check(within(row.min, row.max));
    }
}

void declare_cube(CLI::App& app, Options& options) {
    declare(app, cube_numbers(), options.cube);
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        app.add_flag(fmt::format("--{}", row.flag), row.of(options.cube), std::string(row.help));
    }
}

void declare_effects(CLI::App& app, Options& options) {
    app.add_flag_function(
        "--fxaa,!--no-fxaa", [&options](std::int64_t count) { options.fxaa = count > 0; },
        "Antialiasing; by default on for scenes and off for pictures");
    app.add_flag_function(
        "--dither,!--no-dither", [&options](std::int64_t count) { options.dither = count > 0; },
        "Spread the rounding to 8 bits, so that smooth ramps show no contours; by default on in "
        "the "
        "window and off without it");
    app.add_option_function<std::vector<std::string>>(
           "--effect",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   put_use(options.effects, parse_use(text));
               }
           },
           "Lays an effect over the picture, as vignette or vignette:strength=0.5,angle=90; --list "
           "has them. May be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME[:PARAMETER=VALUE,...]");
    app.add_option("--without", options.without,
                   "Parts of the frame and effects to switch off, with commas between them, from "
                   "--list")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("PARTS");
    app.add_option(
           "--light", options.lights,
           "Changes a light, as sun.intensity=2 or 1.color=1,0.5,0; --list has the controls. "
           "May be repeated")
        ->allow_extra_args(false)
        ->type_name("LIGHT.CONTROL=VALUE");
}

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
    set_usual(uses, options.fxaa.value_or(is_scene));
    for (const EffectUse& use : options.effects) {
        put_use(uses, use);
    }
    return uses;
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

std::string line_of(std::string_view name, std::string_view text) {
    return fmt::format("  {:<20} {}\n", name, text);
}

template <class Rows>
std::string section(std::string_view title, const Rows& rows) {
    std::string out = fmt::format("{}\n", title);
    for (const auto& row : rows) {
        out += line_of(row.name, text_of(row));
    }
    return out;
}

template <class S>
std::string section_of(const ChoiceRow<S>& row) {
    std::string out = fmt::format("{} (--{})\n", row.title, row.flag);
    for (const Option& option : row.options()) {
        out += line_of(option.name, option.text);
    }
    return out;
}

template <class S>
std::string section_of(std::string_view title, std::span<const NumberRow<S>> rows) {
    const S usual;
    std::string out = fmt::format("{}\n", title);
    for (const NumberRow<S>& row : rows) {
        // The help of one that stands for something says so.
        const std::string fallback =
            row.is_own(usual) ? "" : fmt::format(", by default {}", row.value(usual));
        out += line_of(fmt::format("--{}", row.flag),
                       fmt::format("{}; {} to {}{}", row.help, row.min, row.max, fallback));
    }
    return out;
}

std::string camera_listing() {
    std::string out = "Camera\n";
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        out += line_of(fmt::format("--{}", row.flag),
                       fmt::format("{}; {} to {}, added to the scene's", row.help, -reach_of(row),
                                   reach_of(row)));
    }
    return out;
}

std::string surroundings_listing() {
    std::string out = section("Surroundings (--surroundings)", surroundings_kinds());
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        out += line_of(
            fmt::format("--{}", row.flag),
            fmt::format("{}; {} to {}, by default the scene's", row.help, row.min, row.max));
    }
    return out;
}

std::string cube_listing() {
    std::string out = section_of("Cube view", cube_numbers());
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        out += line_of(fmt::format("--{}", row.flag), row.help);
    }
    return out;
}

std::string effects_listing() {
    std::string out = "Effects (--effect)\n";
    for (const PostEffect* effect : post_effects()) {
        out += line_of(effect->name,
                       fmt::format("{}; {}", effect->help,
                                   stages()[static_cast<std::size_t>(effect->stage)].help));
        for (const lutlib::Parameter& parameter : effect->parameters) {
            out += line_of(fmt::format("  {}", parameter.name),
                           fmt::format("{}; {} to {}, by default {}", parameter.label,
                                       parameter.min, parameter.max, parameter.fallback));
        }
    }
    return out;
}

} // namespace

Size parse_size(std::string_view option, const std::string& text) {
    Size size;
    if (reads_pair(text, 'x', size.width, size.height) && size.width > 0 && size.height > 0 &&
        size.width <= largest_side && size.height <= largest_side) {
        return size;
    }
    throw lutlib::UsageError(fmt::format("{} needs WIDTHxHEIGHT with sides of 1 to {}, got '{}'",
                                         option, largest_side, text));
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

void declare(CLI::App& app, Options& options) {
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        declare<PictureSettings>(app, row, options.frame);
    }
    app.get_option("--compare")->default_str("")->each([&options](const std::string&) {
        options.is_compare_given = true;
    });
    for (const auto& [flag, is_given] : {std::pair{"--tonemap", &Options::is_tonemap_given},
                                         std::pair{"--bloom", &Options::is_bloom_given}}) {
        app.get_option(flag)->each(
            [&options, member = is_given](const std::string&) { options.*member = true; });
    }
    declare<PictureSettings>(app, picture_numbers(), options.frame);
    declare_effects(app, options);
    declare_camera(app, options);
    declare_surroundings(app, options);
    declare_cube(app, options);
    for (const ChoiceRow<Options>& row : option_choices()) {
        declare(app, row, options);
    }
    for (const OptionRow& row : option_rows()) {
        declare(app, row, options);
    }
}

FrameSettings settings_of(const Options& options, Size input_size) {
    FrameSettings settings = options.frame;
    if (!options.is_compare_given) {
        settings.compare = options.look_b.empty() ? &compare_a : &compare_split;
    }
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
    settings.effects = effects_of(options, input_size == Size{});
    for (const std::string& name : options.without) {
        leave_out(settings, name);
    }
    settings.output = output_size(options, settings, input_size);
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

Orbit named_camera(const Options& options, const Scene& scene) {
    std::vector<std::string_view> names;
    for (const NamedCamera& camera : scene.cameras) {
        if (camera.name == options.camera_name) {
            return camera.orbit;
        }
        names.push_back(camera.name);
    }
    if (names.empty()) {
        throw lutlib::UsageError("--camera: '" + options.input + "' has no cameras");
    }
    lutlib::refuse_name("camera", options.camera_name, names);
}

} // namespace

Orbit orbit_of(const Options& options, const Scene& scene) {
    Orbit orbit = options.camera_name.empty() ? scene.orbit : named_camera(options, scene);
    for (std::size_t i = 0; i < options.camera.size(); ++i) {
        camera_numbers()[i].of(orbit) += options.camera[i];
    }
    return orbit;
}

std::string listing() {
    std::string out = section("Scenes", scenes()) + section("Lookups (--engine)", gpu_lookups());
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        out += section_of(row);
    }
    for (const ChoiceRow<Options>& row : option_choices()) {
        out += section_of(row);
    }
    return out + section_of("Settings", picture_numbers()) + camera_listing() +
           surroundings_listing() + cube_listing() + effects_listing() +
           section("Parts of the frame (--without, as effects)", effects) +
           section("Lights' controls (--light)", light_controls());
}

} // namespace preview
