#include "preview/cli/option_rows.h"

#include "preview/effects/effect.h"
#include "preview/frame/frame.h"

#include <algorithm>

namespace preview {

namespace {

using O = Options;

constexpr OptionRow rows[] = {
    {.flag = "input",
     .help =
         "A built-in scene (--list), a model (glTF 2.0, OBJ), or a picture file, shown in place of "
         "a scene; or check, which prints how the renderer bears extreme inputs of the scene, "
         "model or picture after it, or report, which measures what settings of its passes cost",
     .of = [](O& o) -> std::string& { return o.input; }},
    {.flag = "subject",
     .help = "What check and report look at, by default the sample",
     .of = [](O& o) -> std::string& { return o.subject; }},
    {.flag = "--a",
     .help = "Look of side A: none, or any LUT file or picture",
     .of = [](O& o) -> std::string& { return o.look_a; },
     .type = "LOOK"},
    {.flag = "--b",
     .help = "Look of side B",
     .of = [](O& o) -> std::string& { return o.look_b; },
     .type = "LOOK"},
    {.flag = "--engine-a",
     .help = "The engine or other lookup of --list that reads side A's look; a look that is not a "
             "picture is baked for it",
     .of = [](O& o) -> std::string& { return o.engine_a; },
     .type = "ENGINE"},
    {.flag = "--engine,--engine-b",
     .help = "The same for side B's look",
     .of = [](O& o) -> std::string& { return o.engine_b; },
     .type = "ENGINE"},
    {.flag = "--look-input-a",
     .help = "Encoding of the inputs of side A's look, instead of what its file says: a curve or "
             "curve/gamut of 'lutconv encodings'",
     .of = [](O& o) -> std::string& { return o.look_input_a; },
     .type = "ENCODING"},
    {.flag = "--look-output-a",
     .help = "Encoding of its results, likewise",
     .of = [](O& o) -> std::string& { return o.look_output_a; },
     .type = "ENCODING"},
    {.flag = "--look-input,--look-input-b",
     .help = "Encoding of the inputs of side B's look",
     .of = [](O& o) -> std::string& { return o.look_input_b; },
     .type = "ENCODING"},
    {.flag = "--look-output,--look-output-b",
     .help = "Encoding of its results",
     .of = [](O& o) -> std::string& { return o.look_output_b; },
     .type = "ENCODING"},
    {.flag = "--still,--still-a",
     .help =
         "A picture that side A shows as it is, in place of a look: a reference to compare with",
     .of = [](O& o) -> std::string& { return o.still_a; },
     .type = "PICTURE"},
    {.flag = "--still-b",
     .help = "The same for side B",
     .of = [](O& o) -> std::string& { return o.still_b; },
     .type = "PICTURE"},
    {.flag = "--still-encoding",
     .help =
         "Decode stills by this encoding and show them as sRGB; by default their codes are shown "
         "as they are, and light is encoded by sRGB's curve",
     .of = [](O& o) -> std::string& { return o.still_encoding; },
     .type = "ENCODING"},
    {.flag = "--picture-encoding",
     .help = "Encoding of the picture that the looks are applied to; a scene is sRGB after its "
             "tone map",
     .of = [](O& o) -> std::string& { return o.picture_encoding; },
     .type = "ENCODING"},
    {.flag = "--no-convert",
     .help = "Never convert, even where a look is made for other encodings",
     .of = [](O& o) -> bool& { return o.no_convert; }},
    {.flag = "--time",
     .help = "The moment of the scene, in seconds",
     .of = [](O& o) -> double& { return o.seconds; },
     .min = -1e6,
     .max = 1e6},
    {.flag = "--camera",
     .help = "A model's camera by its name, or one that the window has kept; by default the first",
     .of = [](O& o) -> std::string& { return o.camera_name; },
     .type = "NAME"},
    {.flag = "--surroundings",
     .help = "What stands around the scene: sky, noise, gradient (the scene's own), or an "
             "equirectangular "
             "picture file, such as an .exr",
     .of = [](O& o) -> std::string& { return o.surroundings; },
     .type = "NAME"},
    {.flag = "--shadow-size",
     .help =
         "Width and height of a shadow map, in texels; by default the scene's: 1024, or 2048 of "
         "the sample",
     .of = [](O& o) -> std::uint32_t& { return o.frame.shadow_size; },
     .min = 16,
     .max = 8192},
    {.flag = "--headless",
     .help = "Render without a window",
     .of = [](O& o) -> bool& { return o.headless; }},
    {.flag = "--size",
     .help = "Size of the output, within which a picture keeps its proportions; by default the "
             "picture's own or 1280x720",
     .of = [](O& o) -> std::string& { return o.size; },
     .type = "WxH"},
    {.flag = "-o,--output",
     .help = "Picture file: PNG with the codes, or any that OpenImageIO writes; .exr and .hdr hold "
             "light (--exr); of a --scope also .csv, with its counts",
     .of = [](O& o) -> std::string& { return o.output; }},
    {.flag = "--depth",
     .help =
         "How the file keeps a number: uint8, uint16, half or float; by default 8 bits, or half "
         "in .exr",
     .of = [](O& o) -> std::string& { return o.depth; }},
    {.flag = "--cube-view",
     .help = "Draw the look of side a or b as the cube of its nodes, without a GPU",
     .of = [](O& o) -> std::string& { return o.cube_view; },
     .one_of = {"a", "b"}},
    {.flag = "--cube-nodes",
     .help = "Most nodes drawn along an axis",
     .of = [](O& o) -> int& { return o.cube_nodes; },
     .min = 2,
     .max = 65},
    {.flag = "--probe",
     .help = "Print the colour of this texel before the looks and after each side's",
     .of = [](O& o) -> std::string& { return o.probe; },
     .type = "X,Y"},
    {.flag = "--meter",
     .help = "Set the exposure so that this texel, or with 'all' the picture's mean, is 18 % grey; "
             "--exposure is added. A sequence keeps what --time shows",
     .of = [](O& o) -> std::string& { return o.meter; },
     .type = "X,Y or all"},
    {.flag = "--focus-at",
     .help = "Focus depth of field on what is at this texel",
     .of = [](O& o) -> std::string& { return o.focus_at; },
     .type = "X,Y"},
    {.flag = "--scope-size",
     .help = "Size of the scope's picture",
     .of = [](O& o) -> std::string& { return o.scope_size; },
     .type = "WxH"},
    {.flag = "--scope-region",
     .help = "Measure this part of the picture alone, in its pixels; side by side in each",
     .of = [](O& o) -> std::string& { return o.scope_region; },
     .type = "X,Y,W,H"},
    {.flag = "--scope-encoding",
     .help = "Levels of waveform, parade, rgb and histogram: the same colours in this encoding, a "
             "curve or curve/gamut of 'lutconv encodings' (pq, linear, hlg), in place of the codes "
             "as they are shown",
     .of = [](O& o) -> std::string& { return o.scope_encoding; },
     .type = "ENCODING"},
    {.flag = "--display-white",
     .help =
         "The display's white in cd/m2: what levels in PQ and luminances in the window are told "
         "for",
     .of = [](O& o) -> double& { return o.display_white; },
     .min = least_display_white,
     .max = most_display_white},
    {.flag = "--explain",
     .help = "Print each pass: kept or left out, and why; and the settings",
     .of = [](O& o) -> bool& { return o.explain; }},
    {.flag = "--force-all",
     .help = "Run every pass in every frame, even those that this scene does not need",
     .of = [](O& o) -> bool& { return o.frame.force_all; }},
    {.flag = "--timings",
     .help = "Print the median GPU time of each pass",
     .of = [](O& o) -> bool& { return o.timings; }},
    {.flag = "--frames",
     .help =
         "How many frames --timings measures, or, as 0-119, a sequence: each into a file, whose "
         "number stands in -o for ####",
     .of = [](O& o) -> std::string& { return o.frames; },
     .type = "N or FIRST-LAST"},
    {.flag = "--frame-rate",
     .help = "Frames of a sequence in a second; frame 0 is at --time",
     .of = [](O& o) -> double& { return o.frame_rate; },
     .min = 0.001,
     .max = 1000},
    {.flag = "--resume",
     .help = "Leave out frames of a sequence whose file is there already",
     .of = [](O& o) -> bool& { return o.resume; }},
    {.flag = "--quiet",
     .help = "Print neither the figures of --compare diff nor a sequence's count; warnings and "
             "errors are still said",
     .of = [](O& o) -> bool& { return o.quiet; }},
    {.flag = "-v,--verbose",
     .help = "Say which device renders, and each file that is written",
     .of = [](O& o) -> bool& { return o.verbose; }},
    {.flag = "--json",
     .help = "Timings, the probe, figures, errors and a report as JSON",
     .of = [](O& o) -> bool& { return o.json; }},
    {.flag = "--csv",
     .help = "The rows of a report as CSV",
     .of = [](O& o) -> bool& { return o.csv; }},
    {.flag = "--passes",
     .help = "Of a report: only these of its passes, as bloom,occlusion",
     .of = [](O& o) -> std::string& { return o.passes; },
     .type = "NAMES"},
    {.flag = "--budget-ms",
     .help = "Of a report: milliseconds of a frame within which it chooses the settings of all "
             "passes; by default what the usual settings take",
     .of = [](O& o) -> double& { return o.budget_ms; },
     .min = 0.001,
     .max = 1e6},
    {.flag = "--max-delta-e",
     .help = "Of a report: the largest dE2000 of the finished picture, at 99 % of its pixels, with "
             "which it chooses the fastest settings",
     .of = [](O& o) -> double& { return o.max_delta_e; },
     .min = 0.001,
     .max = 100},
    {.flag = "--list",
     .help = "Print scenes, lookups, every choice and setting, effects, lights' controls, devices",
     .of = [](O& o) -> bool& { return o.list; }},
    {.flag = "--device",
     .help = "Part of a GPU's name, or its number in --list",
     .of = [](O& o) -> std::string& { return o.device; }},
    {.flag = "--font",
     .help = "The window's font, a TrueType or OpenType file",
     .of = [](O& o) -> std::string& { return o.font; }},
    {.flag = "--watch-engine-folder",
     .help =
         "A folder of an engine's project, which the engine watches: Ctrl+E in the window writes "
         "the look's strip there, named as the look is",
     .of = [](O& o) -> std::string& { return o.engine_folder; },
     .type = "DIR"},
    {.flag = "--places",
     .help = "Keep in this file where the window's controls are, for scripts: a line 'NAME X Y "
             "WIDTH HEIGHT' for each, in pixels, after 'frame NUMBER' and where the mouse was last "
             "seen, 'mouse X Y'; written when all that happened up to then is drawn",
     .of = [](O& o) -> std::string& { return o.places; }},
    {.flag = "--validate",
     .help = "Run under Vulkan's validation layers",
     .of = [](O& o) -> bool& { return o.validate; }},
    {.flag = "--no-sandbox",
     .help = "Let OpenImageIO, OpenColorIO and Assimp read files in this process, with all that it "
             "may do",
     .of = [](O& o) -> bool& { return o.no_sandbox; }},
    {.flag = "--allow-outside",
     .help = "Let models and recipes name files outside their own folder",
     .of = [](O& o) -> bool& { return o.allow_outside; }},
    {.flag = "--max-memory",
     .help = "GiB that a process which reads a file for them may take",
     .of = [](O& o) -> double& { return o.max_memory; },
     .min = 0.125,
     .max = 1024},
};

constexpr OptionRow picture_rows[] = {
    {.flag = "--fxaa,!--no-fxaa",
     .help = "Antialiasing; by default on for scenes but the chart, off for pictures",
     .of = [](O& o) -> std::optional<bool>& { return o.fxaa; }},
    {.flag = "--dither,!--no-dither",
     .help = "Spread the rounding to 8 bits, so that smooth ramps show no contours; by default on "
             "in the window and off without it",
     .of = [](O& o) -> std::optional<bool>& { return o.dither; }},
};

std::span<const Scope> scope_rows() {
    return scopes;
}

std::span<const LookAt> look_at_rows() {
    return look_ats;
}

std::span<const ScopeSide> scope_side_rows() {
    return scope_sides;
}

/// The intermediates, then what each effect makes.
std::vector<Option> view_options() {
    std::vector<Option> out;
    for (const DebugView& view : debug_views()) {
        out.push_back({view.name, view.help});
    }
    for (const PostEffect* effect : post_effects()) {
        out.push_back({effect->name, "what this effect makes of the picture"});
    }
    return out;
}

template <class Row>
void choose(const Row*& member, std::span<const Row> table, std::size_t option) {
    member = &table[option];
}

constexpr ChoiceRow<Options> choices[] = {
    {.flag = "exr",
     .label = "What .exr holds",
     .kind = "content of .exr",
     .title = "Contents of .exr and .hdr",
     .help = "What .exr and .hdr hold, by default light, of a picture that holds codes the picture",
     .options =
         [] {
             return std::vector<Option>{
                 {"light", "the exposed light before bloom and tone map"},
                 {"picture", "the finished picture, decoded from sRGB to light"}};
         },
     .choose = [](O& o, std::size_t i) { o.exr_light = i == 0; }},
    {.flag = "look-at",
     .label = "Place of the looks",
     .kind = "place of a look",
     .title = "Places of the looks",
     .help = "On which side of the tone map the looks stand",
     .options = [] { return options_of(look_at_rows()); },
     .choose = [](O& o, std::size_t i) { choose(o.look_at, look_at_rows(), i); }},
    {.flag = "raster",
     .label = "Rasteriser",
     .kind = "rasteriser",
     .title = "Rasterisers",
     .help = "Rasteriser",
     .options = [] { return options_of(rasters()); },
     .choose = [](O& o, std::size_t i) { choose(o.raster, rasters(), i); }},
    {.flag = "debug-view",
     .label = "View",
     .kind = "debug view",
     .title = "Views",
     .help = "Show an intermediate",
     .options = view_options,
     .choose =
         [](O& o, std::size_t i) {
             const std::size_t views = debug_views().size();
             o.frame.view = i < views ? &debug_views()[i] : nullptr;
             o.frame.effect_view = i < views ? nullptr : post_effects()[i - views];
         }},
    {.flag = "scope",
     .label = "Scope",
     .kind = "scope",
     .title = "Scopes",
     .help = "Show the finished picture on this instrument",
     .options = [] { return options_of(scope_rows()); },
     .choose = [](O& o, std::size_t i) { choose(o.frame.scope, scope_rows(), i); }},
    {.flag = "scope-side",
     .label = "Side of the scope",
     .kind = "side of a scope",
     .title = "Sides of a scope",
     .help = "What the scope measures",
     .options = [] { return options_of(scope_side_rows()); },
     .choose = [](O& o, std::size_t i) { choose(o.frame.scope_side, scope_side_rows(), i); }},
    {.flag = "scope-scale",
     .label = "Scale of the scope",
     .kind = "scale of a scope",
     .title = "Scales of a scope",
     .help = "How counts become brightness or height",
     .options = [] { return options_of(scope_scales); },
     .choose = [](O& o,
                  std::size_t i) { o.frame.scope_logarithmic = scope_scales[i].logarithmic; }},
    {.flag = "scope-gain",
     .label = "Gain of the scope",
     .kind = "gain of a scope",
     .title = "Gains of a scope",
     .help = "How often counts are multiplied before that",
     .options = [] { return options_of(scope_gains); },
     .choose = [](O& o, std::size_t i) { o.frame.scope_gain = &scope_gains[i]; }},
};

} // namespace

std::span<const OptionRow> option_rows() {
    return rows;
}

std::span<const OptionRow> picture_option_rows() {
    return picture_rows;
}

std::span<const ChoiceRow<Options>> option_choices() {
    return choices;
}

} // namespace preview
