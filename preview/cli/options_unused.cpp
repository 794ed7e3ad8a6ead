#include "preview/cli/options_unused.h"

#include "lutlib/io/file.h"
#include "preview/cli/sequence.h"
#include "preview/effects/effect.h"
#include "preview/look/cube_settings.h"
#include "preview/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>

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

/// Of the picture's numbers those that begin so.
std::vector<std::string> picture_flags(std::string_view beginning) {
    std::vector<std::string> out;
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        if (row.flag.starts_with(beginning)) {
            out.push_back(fmt::format("--{}", row.flag));
        }
    }
    return out;
}

bool is_given(const Options& options, const std::string& flag) {
    return std::find(options.given.begin(), options.given.end(), flag) != options.given.end();
}

bool is_any_given(const Options& options, const std::vector<std::string>& flags) {
    return std::any_of(flags.begin(), flags.end(),
                       [&](const std::string& flag) { return is_given(options, flag); });
}

std::vector<std::string> said(const Options& options, const std::vector<Rule>& rules) {
    std::vector<std::string> out;
    for (const Rule& rule : rules) {
        for (const std::string& flag : rule.flags) {
            if (!rule.has_part && is_given(options, flag)) {
                out.push_back(fmt::format("{} changes nothing here: {}", flag, rule.why_not));
            }
        }
    }
    return out;
}

std::vector<Rule> rules_of(const Options& o) {
    const bool window = opens_window(o), is_sequence = parse_frames(o.frames).range.has_value();
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
        {{"--exr"}, output_holds_light(o), "it is for an output of .exr or .hdr"},
        {{"--font", "--places"}, window, "no window opens"},
    };
}

/// "a", "a and b", "a, b and c".
std::string enumerated(const std::vector<std::string>& items) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        out += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    }
    return out;
}

} // namespace

bool output_holds_light(const Options& options) {
    const std::string extension = lutlib::io::extension_of(options.output);
    return extension == "exr" || extension == "hdr";
}

std::vector<std::string> unused_options(const Options& options) {
    return said(options, rules_of(options));
}

std::vector<AskedPart> asked_parts(const Options& options) {
    std::vector<AskedPart> out;
    for (const EffectUse& use : options.effects) {
        out.push_back(
            {std::string(use.effect->name), fmt::format("--effect {}", use.effect->name)});
    }
    if (!options.focus_at.empty()) {
        out.push_back({"depth-of-field", "--focus-at"});
    }
    if (options.fxaa.value_or(false)) {
        out.push_back({"fxaa", "--fxaa"});
    }
    if (options.dither.value_or(false)) {
        out.push_back({"dither", "--dither"});
    }
    out.erase(std::remove_if(out.begin(), out.end(),
                             [&](const AskedPart& part) {
                                 return std::find(options.without.begin(), options.without.end(),
                                                  part.name) != options.without.end();
                             }),
              out.end());
    return out;
}

std::string not_in_light(const Options& options, const FrameSettings& settings) {
    std::vector<std::string> bloom = picture_flags("bloom"), missing;
    bloom.emplace_back("--bloom");
    if (is_any_given(options, bloom)) {
        missing.emplace_back("the bloom");
    }
    if (is_given(options, "--tonemap")) {
        missing.emplace_back("the tone map");
    }
    if (is_look(options.look_a) || is_look(options.look_b)) {
        missing.emplace_back("the looks");
    }
    if (is_given(options, "--compare")) {
        missing.emplace_back("the comparison");
    }
    for (const AskedPart& part : asked_parts(options)) {
        const PostEffect* const effect = post_effect_named(part.name);
        const EffectUse* const use =
            effect != nullptr ? use_of(settings.effects, *effect) : nullptr;
        if (use != nullptr && stage_of(*use) != Stage::hdr &&
            std::find(missing.begin(), missing.end(), part.name) == missing.end()) {
            missing.push_back(part.name);
        }
    }
    return missing.empty()
               ? std::string()
               : fmt::format("'{}' holds the light before bloom and tone map, without {}: add "
                             "--exr picture for the finished picture",
                             options.output, enumerated(missing));
}

} // namespace preview
