// The command line of lutpreview.
#pragma once

#include "preview/frame/settings.h"
#include "preview/look/cube_view.h"
#include "preview/look/look_standing.h"
#include "preview/scene/camera_settings.h"
#include "preview/scene/scene.h"
#include "preview/scene/surroundings.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace preview {

struct Study;

struct Options {
    std::string input = "sample"; ///< a built-in scene, a model or a picture file
    const Study* study = nullptr; ///< what is asked about it in place of its picture
    std::string subject;          ///< the word after the study's; input holds it once parsed
    std::string look_a = "none", look_b;
    std::string engine_a, engine_b;          ///< lookups that read them
    std::string look_input_a, look_output_a; ///< of the looks' codes; empty: as each says
    std::string look_input_b, look_output_b;
    std::string still_a, still_b;          ///< pictures in place of looks; empty: none
    std::string still_encoding;            ///< of their numbers; empty: as their files say
    std::string picture_encoding = "srgb"; ///< of the codes that the looks get
    bool no_convert = false;               ///< whatever the looks are made for
    const LookAt* look_at = &look_at_auto;
    /// What the frame is asked for; settings_of() completes it.
    FrameSettings frame;
    bool is_compare_given = false;
    bool is_tonemap_given = false, is_bloom_given = false; ///< else the scene's own
    std::optional<bool> fxaa;         ///< empty: as usual_finish() and pictures have it
    std::optional<bool> dither;       ///< empty: on in the window, else off
    EffectUses effects;               ///< that are put in
    std::vector<std::string> without; ///< names of parts of the frame and of effects
    std::vector<std::string> lights;  ///< changes, as edit_light() takes them
    std::string surroundings;         ///< a kind's name or a picture file; empty: the scene's own
    /// Of each row of surroundings_numbers(), in place of the scene's.
    std::vector<std::optional<float>> surroundings_numbers =
        std::vector<std::optional<float>>(preview::surroundings_numbers().size());
    const RasterChoice* raster = &rasters().front();
    std::string size, probe, meter, scope_size, scope_region, focus_at;
    std::string scope_encoding; ///< of the scope's levels; empty: the codes as they are shown
    double seconds = 0;
    double display_white = static_cast<double>(usual_display_white); ///< cd/m2
    std::string camera_name; ///< of the file's cameras; empty: the first
    /// Of each row of camera_numbers(): added to the scene's.
    std::vector<float> camera = std::vector<float>(camera_numbers().size());
    std::string cube_view; ///< the side whose look is drawn as a cube; empty: none
    int cube_nodes = 17;
    CubeView cube;
    bool csv = false;        ///< of a report
    std::string passes;      ///< of a report, with commas between them; empty: all
    double budget_ms = -1;   ///< of a frame; negative: as the usual settings take
    double max_delta_e = -1; ///< negative: the budget counts
    bool headless = false, explain = false, timings = false, json = false, list = false;
    bool quiet = false;   ///< no figures that were not asked for, no counts
    bool verbose = false; ///< the device, and each file that is written
    bool validate = false;
    bool no_sandbox = false, allow_outside = false;
    double max_memory = 4;     ///< GiB, of each process that reads files for a library
    std::string frames = "50"; ///< parse_frames()
    double frame_rate = 24;    ///< of a sequence, in 1/s
    bool resume = false;
    std::string output, device;
    std::string depth;     ///< of the output; empty: as files of its name usually have
    bool exr_light = true; ///< files that hold light get that before the tone map
    std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"; ///< of the window
    std::string engine_folder;      ///< where the window exports strips at the press of a key
    std::string places;             ///< file that tells where the window's controls are
    std::vector<std::string> given; ///< each name, as "--split", of the options that were given
    /// A sentence for each option that was given and changes nothing in what the others ask for.
    std::vector<std::string> unused;
};

/// Declares every option on `app`; parsing fills `options`, which must outlive it.
void declare(CLI::App& app, Options& options);

/// Whether the option was given, by its name as "--split".
bool is_given(const Options& options, const std::string& flag);

/// What lutpreview can be asked about its input, by the first word of the command line.
struct Study {
    std::string_view name;
    std::string_view help;
    bool writes_page = false; ///< into the output file
};
std::span<const Study> studies();

/// Whether they ask for the window, as those do that ask for nothing else.
bool opens_window(const Options& options);

/// Whether a side shows a reference still.
bool shows_stills(const Options& options);

/// The comparison: as given, else A alone, or both sides when there is a look for B or a
/// still.
const Compare* compare_of(const Options& options);

/// What the options say of the frame; `input_size` is a picture's own size, or {} for a scene.
/// Throws lutlib::UsageError for names that no table has, with those that it has.
FrameSettings settings_of(const Options& options, Size input_size);

/// The scene's lights, changed as the options say. Throws lutlib::UsageError.
std::vector<PointLight> lights_of(const Options& options, const std::optional<Scene>& scene);

/// What surrounds the scene, changed as the options say.
Surroundings surroundings_of(const Options& options, const Scene& scene);
/// The file that --surroundings names; empty where it is none.
std::string surroundings_file(const Options& options);

/// The scene's camera, or the one that is named, of its cameras or of those that `kept` has of an
/// input, moved as the options say. Throws lutlib::UsageError when none has the name.
Orbit orbit_of(const Options& options, const Scene& scene,
               std::vector<NamedCamera> (*kept)(const std::string& input));

/// How far a number of the camera may be moved: from any place of its range to any other.
double reach_of(const NumberRow<Orbit>& row);

/// WIDTHxHEIGHT with sides of 1 to 16384. Throws lutlib::UsageError that names the option.
Size parse_size(std::string_view option, const std::string& text);
/// An encoding by its name. Throws lutlib::UsageError that begins with the option's.
lutlib::Encoding encoding_of(const std::string& name, const std::string& flag);
/// X,Y within a picture of that size. Throws lutlib::UsageError that names the option.
ProbePlace parse_place(std::string_view option, const std::string& text, Size picture);
/// X,Y,WIDTH,HEIGHT within a picture of that size. Throws lutlib::UsageError that names the option.
ScopeRegion parse_region(std::string_view option, const std::string& text, Size picture);

} // namespace preview
