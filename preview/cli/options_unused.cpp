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
    std::string why_not;
};

bool is_look(const std::string& path) {
    return !path.empty() && path != "none";
}

template <class S>
std::vector<std::string> flags_of(std::span<const NumberRow<S>> rows) {
    std::vector<std::string> out;
    for (const NumberRow<S>& row : rows) {
        out.push_back(fmt::format("--{}", row.flag));
    }
    return out;
}

std::vector<std::string> cube_flags() {
    std::vector<std::string> out = flags_of(cube_numbers());
    out.emplace_back("--cube-nodes");
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

bool is_without(const Options& options, const std::string& name) {
    return std::find(options.without.begin(), options.without.end(), name) != options.without.end();
}

std::vector<std::string> bloom_flags() {
    std::vector<std::string> out = picture_flags("bloom");
    out.emplace_back("--bloom");
    return out;
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

/// The options that were given and have no part in the cube of a side's look.
Rule cube_rule(const Options& options) {
    const std::string& side = options.cube_view;
    std::vector<std::string> taken = cube_flags();
    for (const std::string_view flag : {"cube-view", "size", "output", "depth", "headless",
                                        "picture-encoding", "no-convert", "look-at", "quiet"}) {
        taken.push_back(fmt::format("--{}", flag));
    }
    for (const std::string_view flag : {"", "engine-", "look-input-", "look-output-"}) {
        taken.push_back(fmt::format("--{}{}", flag, side));
    }
    Rule out{
        {}, false, fmt::format("--cube-view {} draws that side's look and nothing else", side)};
    for (const std::string& flag : options.given) {
        // Other names of options that are given under their own as well.
        const bool is_alias = flag == "--engine" || flag == "--look-input" ||
                              flag == "--look-output" || flag == "--still" || flag == "--no-fxaa" ||
                              flag == "--no-dither";
        if (!is_alias && std::find(taken.begin(), taken.end(), flag) == taken.end()) {
            out.flags.push_back(flag);
        }
    }
    return out;
}

std::string why_no_picture(const Options& options) {
    return fmt::format("{} writes no picture", options.study->name);
}

std::vector<std::string> report_flags() {
    return {"--csv", "--passes", "--budget-ms", "--max-delta-e"};
}

/// The options that a study, which makes no picture for anybody, does not take.
Rule study_rule(const Options& options) {
    return {{"--depth",         "--cube-view",  "--cube-nodes",     "--probe",
             "--scope",         "--scope-size", "--scope-region",   "--scope-side",
             "--scope-scale",   "--scope-gain", "--scope-encoding", "--display-white",
             "--explain",       "--force-all",  "--timings",        "--frames",
             "--frame-rate",    "--resume",     "--font",           "--watch-engine-folder",
             "--places",        "--exr",        "--dither",         "--debug-view",
             "--heat-scale",    "--meter",      "--still-a",        "--still-b",
             "--still-encoding"},
            false,
            why_no_picture(options)};
}

std::vector<Rule> rules_of(const Options& o) {
    if (o.study != nullptr) {
        return {study_rule(o),
                {{"--output"}, o.study->writes_page, why_no_picture(o)},
                {report_flags(), o.study->writes_page, "it is for report"}};
    }
    if (!o.cube_view.empty()) {
        return {cube_rule(o)};
    }
    const bool window = opens_window(o), is_sequence = parse_frames(o.frames).range.has_value(),
               has_looks = is_look(o.look_a) || is_look(o.look_b);
    const Compare* const compare = compare_of(o);
    return {
        {{"--engine-a", "--look-input-a", "--look-output-a"},
         is_look(o.look_a) || window,
         "side A has no look"},
        {{"--engine-b", "--look-input-b", "--look-output-b"},
         is_look(o.look_b) || window,
         "side B has no look"},
        {{"--still-encoding"}, shows_stills(o), "neither side has a still"},
        {cube_flags(), window, "no --cube-view is drawn"},
        {{"--scope-size", "--scope-region", "--scope-side", "--scope-scale", "--scope-gain",
          "--scope-encoding"},
         o.frame.scope != nullptr || window,
         "no --scope is shown"},
        {{"--scope-scale", "--scope-gain"}, !writes_counts(o), "a .csv has the counts themselves"},
        {{"--depth"}, !writes_counts(o), "a .csv has the counts themselves"},
        {{"--scope-encoding"},
         o.frame.scope == nullptr || has_levels(*o.frame.scope) || window,
         "a vectorscope counts the codes as they are shown"},
        {{"--display-white"},
         (o.frame.scope != nullptr && !o.scope_encoding.empty()) || window,
         "no --scope-encoding is given"},
        {report_flags(), false, "it is for 'lutpreview report'"},
        {{"--frames"}, o.timings || is_sequence, "--timings takes it"},
        {{"--frame-rate", "--resume"}, is_sequence, "--frames names no sequence, as 0-119 does"},
        {{"--depth"}, !o.output.empty(), "no picture is written; -o names one"},
        {{"--exr"}, output_holds_light(o), "it is for an output of .exr or .hdr"},
        {{"--exr"},
         !output_holds_light(o) || (!o.frame.shows_intermediate() && o.frame.scope == nullptr),
         "it is for the picture, not for what --debug-view and --scope show"},
        {{"--font", "--places", "--watch-engine-folder"}, window, "no window opens"},
        {{"--meter"}, !window, "the panel View has a meter; this one is for a picture"},
        {{"--quiet", "--verbose"}, !window, "the window prints nothing"},
        {{"--split", "--split-angle"},
         compare == &compare_split || window,
         "it is for --compare split"},
        {picture_flags("box-"), compare == &compare_box || window, "it is for --compare box"},
        {{"--zebra-level"},
         o.frame.picture_view == picture_view_named("zebra") || window,
         "it is for --view zebra"},
        {{"--zoom-x", "--zoom-y", "--magnify"},
         o.frame.zoom.scale > 0 || window,
         "all of the picture is seen; --zoom shows a part"},
        {{"--zoom"},
         (o.frame.scope == nullptr && !o.frame.shows_intermediate()) || window,
         "it is for the picture, not for what --scope and --debug-view show"},
        {{"--view"}, o.frame.scope == nullptr || window, "--scope measures the picture itself"},
        {{"--view"},
         !o.frame.shows_intermediate() || window,
         "it is for the picture, not for what --debug-view shows"},
        {{"--view"},
         compare != &compare_difference || window,
         "a heat map (--compare diff) is no picture to look at"},
        {{"--heat-scale"}, compare == &compare_difference || window, "it is for --compare diff"},
        {{"--picture-encoding"},
         has_looks || window || (o.frame.scope != nullptr && !o.scope_encoding.empty()),
         "neither side has a look"},
        {{"--no-convert", "--look-at"}, has_looks || window, "neither side has a look"},
        {bloom_flags(), !is_without(o, "bloom"), "--without bloom switches it off"},
        {{"--tonemap"}, !is_without(o, "tonemap"), "--without tonemap switches it off"},
        {{"--focus-at"},
         !is_without(o, "depth-of-field"),
         "--without depth-of-field switches it off"},
        {{"--fxaa"},
         !is_without(o, "fxaa") || !o.fxaa.value_or(true),
         "--without fxaa switches it off"},
    };
}

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// "a", "a and b", "a, b and c".
std::string enumerated(const std::vector<std::string>& items, std::string_view last) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        out += i == 0                  ? items[i]
               : i + 1 == items.size() ? fmt::format(" {} {}", last, items[i])
                                       : ", " + items[i];
    }
    return out;
}

/// A rule for each number of surroundings that those of this kind have not.
void add_surroundings(std::vector<Rule>& rules, SurroundingsKind kind) {
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        bool has_part = false;
        std::vector<std::string> kinds;
        for (const SurroundingsInfo& info : surroundings_kinds()) {
            if (std::any_of(
                    info.numbers.begin(), info.numbers.end(),
                    [&](const NumberRow<Surroundings>& own) { return own.flag == row.flag; })) {
                has_part = has_part || info.kind == kind;
                kinds.push_back(
                    fmt::format("--surroundings {}",
                                info.kind == SurroundingsKind::picture ? "FILE" : info.name));
            }
        }
        rules.push_back(
            {{fmt::format("--{}", row.flag)}, has_part, "it is for " + enumerated(kinds, "or")});
    }
}

} // namespace

bool output_holds_light(const Options& options) {
    const std::string extension = lutlib::io::extension_of(options.output);
    return extension == "exr" || extension == "hdr";
}

bool writes_counts(const Options& options) {
    return options.frame.scope != nullptr && lutlib::io::extension_of(options.output) == "csv";
}

std::vector<std::string> unused_options(const Options& options) {
    std::vector<std::string> out = said(options, rules_of(options));
    if (!options.cube_view.empty() &&
        !is_look(options.cube_view == "a" ? options.look_a : options.look_b)) {
        out.push_back(fmt::format("--cube-view {0} draws nodes that no look has moved: --{0} names "
                                  "a look",
                                  options.cube_view));
    }
    for (const EffectUse& use : options.effects) {
        const std::string name(use.effect->name);
        if (is_without(options, name) && options.cube_view.empty()) {
            out.push_back(fmt::format("--effect {0} changes nothing here: --without {0} switches "
                                      "it off",
                                      name));
        }
    }
    return out;
}

std::vector<std::string> unused_options(const Options& options, const KnownInput& input,
                                        const FrameSettings& settings) {
    std::vector<Rule> rules{
        {{"--surroundings", "--shadow-size", "--raster", "--camera"},
         input.scene != nullptr,
         "a picture is shown"},
        {joined(flags_of(camera_numbers()), picture_flags("occlusion")), input.scene != nullptr,
         "a picture is shown"},
        {{"--shadow-filter", "--occlusion-resolution"},
         input.scene != nullptr,
         "a picture is shown"},
        {picture_flags("bloom"), input.has_codes || settings.bloom != bloom_named("none"),
         "there is no bloom (--bloom none)"},
        {joined(bloom_flags(), {"--tonemap", "--meter"}), !input.has_codes,
         "the picture is display-encoded already"},
    };
    if (output_holds_light(options) && options.exr_light) {
        rules.push_back({{"--exr"}, !input.has_codes, "the picture holds codes and no light"});
    }
    if (input.scene == nullptr) {
        rules.push_back({flags_of(surroundings_numbers()), false, "a picture is shown"});
    } else {
        add_surroundings(rules, surroundings_of(options, *input.scene).kind);
    }
    std::vector<std::string> out = said(options, rules);
    if (settings.without.has(Effect::floor) && (input.scene == nullptr || !input.scene->floor)) {
        out.push_back(fmt::format("--without floor changes nothing here: {}",
                                  input.scene == nullptr ? "a picture is shown"
                                                         : "no floor was put under the scene"));
    }
    return out;
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
                             [&](const AskedPart& part) { return is_without(options, part.name); }),
              out.end());
    return out;
}

std::string not_in_light(const Options& options, const FrameSettings& settings) {
    std::vector<std::string> missing;
    if (is_any_given(options, bloom_flags())) {
        missing.emplace_back("the bloom");
    }
    if (is_given(options, "--tonemap")) {
        missing.emplace_back("the tone map");
    }
    if (is_look(options.look_a) || is_look(options.look_b)) {
        missing.emplace_back("the looks");
    }
    if (shows_stills(options)) {
        missing.emplace_back("the still");
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
                             options.output, enumerated(missing, "and"));
}

} // namespace preview
