#include "preview/cli/options.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "preview/cli/light_edit.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>

namespace preview {

namespace {

constexpr std::uint32_t largest_side = 16384;

template <class Rows>
const auto* require_row(const Rows& rows, const std::string& name, std::string_view what) {
    return &lutlib::require_named(rows, what, name);
}

Size parse_size(std::string_view option, const std::string& text) {
    Size size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        if (height.ec == std::errc{} && height.ptr == end && size.width > 0 && size.height > 0 &&
            size.width <= largest_side && size.height <= largest_side)
            return size;
    }
    throw lutlib::UsageError(fmt::format("{} is WIDTHxHEIGHT with sides of 1 to {}, and not '{}'",
                                         option, largest_side, text));
}

ProbePlace parse_place(const std::string& text, Size picture) {
    ProbePlace place;
    const char* const end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, place.x);
    if (x.ec == std::errc{} && x.ptr != end && *x.ptr == ',') {
        const auto y = std::from_chars(x.ptr + 1, end, place.y);
        if (y.ec == std::errc{} && y.ptr == end && place.x >= 0 && place.y >= 0 &&
            static_cast<std::uint32_t>(place.x) < picture.width &&
            static_cast<std::uint32_t>(place.y) < picture.height)
            return place;
    }
    throw lutlib::UsageError(fmt::format("--probe is X,Y within the picture of {}x{}, and not '{}'",
                                         picture.width, picture.height, text));
}

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

template <class Rows, class Text>
std::string section(std::string_view title, const Rows& rows, Text text) {
    std::string out = fmt::format("{}\n", title);
    for (const auto& row : rows)
        out += fmt::format("  {:<20} {}\n", row.name, text(row));
    return out;
}

} // namespace

void declare(CLI::App& app, Options& options) {
    app.add_option(
        "input", options.input,
        "A built-in scene (--list), a glTF 2.0 file (textures stand as their mean), or a picture "
        "file, which stands for the scene");
    app.add_option("--a", options.look_a, "Look of side A: none, or any LUT file or picture")
        ->type_name("LOOK");
    app.add_option("--b", options.look_b, "Look of side B")->type_name("LOOK");
    app.add_option("--compare", options.compare,
                   "a, b, split, side or diff; by default a, or split when --b is given");
    app.add_option("--split", options.split, "Where the line stands, of the width")
        ->check(within(0, 1));
    app.add_option("--heat-scale", options.heat_scale, "dE2000 at the end of the heat map")
        ->check(within(4, 96));
    app.add_option("--engine", options.engine,
                   "The lookup that reads the looks: an engine's or another of --list");
    app.add_option("--tonemap", options.tonemap, "Tone map, from --list");
    app.add_option("--bloom", options.bloom, "Bloom, from --list");
    app.add_option("--bloom-strength", options.bloom_settings.strength,
                   "Share of the light that blooms; by default the method's own")
        ->check(within(0, 1));
    app.add_option("--bloom-threshold", options.bloom_settings.threshold,
                   "Brightness above which light blooms; 0: all light")
        ->check(within(0, 65504));
    app.add_option("--bloom-knee", options.bloom_settings.knee,
                   "Half width of the soft step about the threshold")
        ->check(within(0, 65504));
    app.add_option("--bloom-radius", options.bloom_settings.radius, "Scales the bloom's width")
        ->check(within(0.05, 8));
    app.add_option("--exposure", options.exposure, "Stops")->check(within(-20, 20));
    app.add_option("--time", options.seconds, "The moment of the scene, in seconds")
        ->check(within(-1e6, 1e6));
    app.add_option("--azimuth", options.azimuth, "Turns the camera to the right, degrees")
        ->check(within(-360, 360));
    app.add_option("--elevation", options.elevation, "Raises the camera, degrees")
        ->check(within(-180, 180));
    app.add_option("--distance", options.distance, "Moves the camera away, metres")
        ->check(within(-1000, 1000));
    app.add_option("--fov", options.field_of_view, "Widens the field of view, degrees")
        ->check(within(-120, 120));
    app.add_flag("--fxaa,!--no-fxaa", options.fxaa,
                 "Antialiasing; by default on for scenes and off for pictures")
        ->each([&options](const std::string&) { options.fxaa_given = true; });
    app.add_option("--without", options.without,
                   "Effects to switch off, with commas between them, from --list")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("EFFECTS");
    app.add_option(
           "--light", options.lights,
           "Changes a light, as key.intensity=2 or 1.color=1,0.5,0; --list has the controls. "
           "May be repeated")
        ->allow_extra_args(false)
        ->type_name("LIGHT.CONTROL=VALUE");
    app.add_option("--shadow-size", options.shadow_size, "Texels of a shadow map's side")
        ->check(CLI::Range(16U, 8192U));
    app.add_option("--raster", options.raster, "Who rasterises, from --list");
    app.add_flag("--headless", options.headless, "Render without a window");
    app.add_option("--size", options.size,
                   "Size of the output, within which a picture keeps its proportions; by default "
                   "the picture's own or 1280x720")
        ->type_name("WxH");
    app.add_option("-o,--output", options.output,
                   "Picture file; .exr and .hdr get the light before tone mapping");
    app.add_option("--debug-view", options.debug_view, "Show an intermediate, from --list");
    app.add_option("--cube-view", options.cube_view,
                   "Draw the look of side a or b as the cube of its nodes, without a GPU")
        ->check(CLI::IsMember({"a", "b"}));
    app.add_option("--cube-nodes", options.cube_nodes, "Nodes of an axis, at most")
        ->check(CLI::Range(2, 65));
    app.add_option("--cube-turn", options.cube.turn, "Turns it about the neutral axis, degrees");
    app.add_option("--cube-tilt", options.cube.tilt, "Degrees; 90 looks down on white")
        ->check(within(-90, 90));
    app.add_option("--cube-zoom", options.cube.zoom, "Brings it nearer")->check(within(0.3, 8));
    app.add_flag("--cube-clamped", options.cube.clamped,
                 "Nodes where a display shows them, within 0 to 1");
    app.add_flag("--cube-by-input", options.cube.by_input,
                 "Dots in the colours that nodes stand for, not those they give");
    app.add_option("--probe", options.probe,
                   "Print the colour of this texel before the looks and after each side's")
        ->type_name("X,Y");
    app.add_option("--scope", options.scope,
                   "Show the finished picture on this instrument, from --list");
    app.add_option("--scope-side", options.scope_side, "shown, a or b: what it looks at");
    app.add_option("--scope-size", options.scope_size, "Size of its picture")->type_name("WxH");
    app.add_option("--scope-scale", options.scope_scale,
                   "log or linear: how counts become brightness or height; by default its own")
        ->check(CLI::IsMember({"log", "linear"}));
    app.add_flag("--explain", options.explain, "Print each pass: kept or left out, and why");
    app.add_flag("--force-all", options.force_all, "Leave out nothing that could be done");
    app.add_flag("--timings", options.timings, "Print the median GPU time of each pass");
    app.add_option("--frames", options.frames, "Frames that --timings measures")
        ->check(CLI::Range(1, 100000));
    app.add_flag("--json", options.json, "Timings and the probe as JSON");
    app.add_flag(
        "--list", options.list,
        "Print scenes, tone maps, blooms, lookups, views, effects, lights' controls, devices");
    app.add_option("--device", options.device, "Part of a GPU's name, or its number in --list");
    app.add_option("--font", options.font, "The window's font, a TrueType or OpenType file");
    app.add_option("--places", options.places,
                   "Keep in this file where the window's controls are, for scripts: a line "
                   "'NAME X Y WIDTH HEIGHT' for each, in pixels, after 'frame NUMBER' and where "
                   "the mouse was last seen, 'mouse X Y'; written when all that happened up to "
                   "then is drawn");
    app.add_flag("--validate", options.validate, "Run under Vulkan's validation layers");
}

FrameSettings settings_of(const Options& options, Size input_size) {
    const bool is_picture = input_size != Size{};
    FrameSettings settings;
    const std::string compare = !options.compare.empty() ? options.compare
                                : options.look_b.empty() ? "a"
                                                         : "split";
    settings.compare = require_row(compares, compare, "comparison");
    settings.tonemap = require_row(tonemaps(), options.tonemap, "tone map");
    settings.bloom = require_row(blooms(), options.bloom, "bloom");
    if (!options.debug_view.empty())
        settings.view = require_row(debug_views(), options.debug_view, "debug view");
    settings.scope_side = require_row(scope_sides, options.scope_side, "side of a scope");
    if (!options.scope_scale.empty())
        settings.scope_logarithmic = options.scope_scale == "log";
    if (!options.scope.empty()) {
        settings.scope = require_row(scopes, options.scope, "scope");
        settings.scope_sizes[static_cast<std::size_t>(settings.scope - scopes.data())] =
            options.scope_size.empty() ? Size{settings.scope->width, settings.scope->height}
                                       : parse_size("--scope-size", options.scope_size);
    }
    settings.bloom_settings = options.bloom_settings;
    settings.split = options.split;
    settings.heat_scale = options.heat_scale;
    settings.exposure = options.exposure;
    settings.without.set(Effect::fxaa, options.fxaa_given ? !options.fxaa : is_picture);
    for (const std::string& name : options.without)
        settings.without.set(require_row(effects, name, "effect")->effect, true);
    settings.shadow_size = options.shadow_size;
    settings.force_all = options.force_all;
    if (!options.size.empty()) {
        settings.output = parse_size("--size", options.size);
        if (is_picture) {
            const std::uint32_t sides = settings.compare == &compare_side ? 2 : 1;
            settings.output = fitted(input_size, picture_size(settings.output, *settings.compare));
            settings.output.width *= sides;
        }
    } else if (is_picture) {
        settings.output = input_size;
        if (settings.compare == &compare_side)
            settings.output.width *= 2;
    }
    if (!options.probe.empty())
        settings.probe = parse_place(options.probe, settings.output);
    if (settings.probe && settings.view != nullptr)
        throw lutlib::UsageError(
            "--probe tells the finished picture, which --debug-view leaves out");
    return settings;
}

std::vector<PointLight> lights_of(const Options& options, const std::optional<Scene>& scene) {
    std::vector<PointLight> lights = scene ? scene->lights : std::vector<PointLight>();
    for (const std::string& text : options.lights)
        edit_light(lights, text);
    return lights;
}

Orbit orbit_of(const Options& options, const Scene& scene) {
    Orbit orbit = scene.orbit;
    orbit.azimuth += options.azimuth;
    orbit.elevation += options.elevation;
    orbit.distance += options.distance;
    orbit.field_of_view += options.field_of_view;
    return orbit;
}

Raster raster_of(const Options& options, const gpu::Device& device, Size size) {
    return require_row(rasters(), options.raster, "rasteriser")->on(device, size);
}

std::string listing() {
    const auto help = [](const auto& row) { return row.help; };
    const auto label = [](const auto& row) { return row.label; };
    return section("Scenes", scenes(), help) + section("Tone maps (--tonemap)", tonemaps(), label) +
           section("Blooms (--bloom)", blooms(), label) +
           section("Lookups (--engine)", gpu_lookups(), label) +
           section("Comparisons (--compare)", compares, label) +
           section("Views (--debug-view)", debug_views(), help) +
           section("Scopes (--scope)", scopes, help) +
           section("Effects (--without)", effects, help) +
           section("Lights' controls (--light)", light_controls(), help) +
           section("Rasterisers (--raster)", rasters(), label);
}

} // namespace preview
