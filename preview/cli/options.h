// The command line of lutpreview.
#pragma once

#include "preview/look/cube_view.h"
#include "preview/frame/frame.h"

#include <string>

namespace CLI {
class App;
}

namespace preview {

struct Options {
    std::string input = "sample"; ///< a built-in scene, a model or a picture file
    std::string look_a = "none", look_b;
    std::string raster = "auto";
    std::string compare, engine, tonemap = "agx", bloom = "glare", size, debug_view, device;
    float split = 0.5F, heat_scale = 8, exposure = 0;
    double seconds = 0;
    float azimuth = 0, elevation = 0, distance = 0, field_of_view = 0; ///< added to the scene's
    std::string cube_view; ///< the side whose look is drawn as a cube; empty: none
    int cube_nodes = 17;
    CubeView cube;
    std::string probe, scope, scope_side = "shown", scope_size, scope_scale;
    BloomSettings bloom_settings{-1, 1, 0.2F, 1};
    std::vector<std::string> without; ///< names of effects
    std::vector<std::string> lights;  ///< changes, as edit_light() takes them
    bool fxaa = true, fxaa_given = false;
    std::uint32_t shadow_size = 1024;
    bool headless = false, explain = false, timings = false, json = false, list = false;
    bool force_all = false, validate = false;
    int frames = 50;
    std::string output;
    std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"; ///< of the window
    std::string places; ///< file that tells where the window's controls are
};

/// Declares every option on `app`; parsing fills `options`, which must outlive it.
void declare(CLI::App& app, Options& options);

/// What the options say of the frame; `input_size` is a picture's own size, or {} for a scene.
/// Throws lutlib::UsageError for names that no table has, with those that it has.
FrameSettings settings_of(const Options& options, Size input_size);

/// The scene's lights, changed as the options say. Throws lutlib::UsageError.
std::vector<PointLight> lights_of(const Options& options, const std::optional<Scene>& scene);

/// The scene's camera, moved as the options say.
Orbit orbit_of(const Options& options, const Scene& scene);

/// Which rasteriser the options choose for the device. Throws lutlib::UsageError for a name that no
/// row has, and where the device cannot do it.
Raster raster_of(const Options& options, const gpu::Device& device, Size size);

/// The tables: scenes, tone maps, blooms, lookups, comparisons, views, effects,
/// lights' controls and rasterisers.
std::string listing();

} // namespace preview
