#include "preview/cli/options_unused.h"

#include "lutlib/named.h"
#include "preview/cli/sequence.h"
#include "preview/look/cube_settings.h"
#include "preview/scene/scene.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace preview {

namespace {

/// Options that have a part in the same runs.
struct Rule {
    std::vector<std::string> flags;
    bool has_part;
    std::string_view why_not;
};

bool is_look(const std::string& path) {
    return !path.empty() && path != "none";
}

std::vector<std::string> cube_flags() {
    std::vector<std::string> out{"--cube-nodes"};
    for (const NumberRow<CubeView>& row : cube_numbers()) {
        out.push_back(fmt::format("--{}", row.flag));
    }
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        out.push_back(fmt::format("--{}", row.flag));
    }
    return out;
}

std::vector<Rule> rules_of(const Options& o) {
    const bool window = opens_window(o), is_sequence = parse_frames(o.frames).range.has_value(),
               is_scene = lutlib::find_named(scenes(), o.input) != nullptr;
    return {
        {{"--engine-a", "--look-input-a", "--look-output-a"},
         is_look(o.look_a) || window,
         "side A has no look"},
        {{"--engine-b", "--look-input-b", "--look-output-b"},
         is_look(o.look_b) || window,
         "side B has no look"},
        {cube_flags(), !o.cube_view.empty() || window, "no --cube-view is drawn"},
        {{"--scope-size", "--scope-side", "--scope-scale"},
         o.frame.scope != nullptr || window,
         "no --scope is shown"},
        {{"--frames"}, o.timings || is_sequence, "--timings takes it"},
        {{"--frame-rate", "--resume"}, is_sequence, "--frames names no sequence, as 0-119 does"},
        {{"--depth"}, !o.output.empty(), "no picture is written; -o names one"},
        {{"--exr"}, !is_scene || window, "a built-in scene is no file"},
        {{"--font", "--places"}, window, "no window opens"},
    };
}

} // namespace

std::vector<std::string> unused_options(const CLI::App& app, const Options& options) {
    std::vector<std::string> out;
    for (const Rule& rule : rules_of(options)) {
        for (const std::string& flag : rule.flags) {
            if (!rule.has_part && app.count(flag) > 0) {
                out.push_back(fmt::format("{} changes nothing here: {}", flag, rule.why_not));
            }
        }
    }
    return out;
}

} // namespace preview
