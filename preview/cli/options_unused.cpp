#include "preview/cli/options_unused.h"

#include "lutlib/named.h"
#include "preview/cli/light_edit.h"
#include "preview/cli/sequence.h"
#include "preview/effects/effect.h"
#include "preview/frame/usual_finish.h"
#include "preview/look/cube_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

namespace preview {

namespace {

bool is_any_given(const Options& options, std::string_view beginning) {
    return std::any_of(options.given.begin(), options.given.end(),
                       [&](const std::string& name) { return name.starts_with(beginning); });
}

constexpr std::string_view says_unused = " changes nothing here: ";

std::string unused_text(std::string_view option, std::string_view why) {
    return fmt::format("{}{}{}", option, says_unused, why);
}

/// A look's cube without a look.
void add_bare_cube(std::vector<std::string>& lines, const Options& options) {
    if (options.study == nullptr && !options.list && !options.cube_view.empty() &&
        !names_look(options.cube_view == "a" ? options.look_a : options.look_b)) {
        lines.push_back(fmt::format("--cube-view {0} draws nodes that no look has moved: --{0} "
                                    "names a look",
                                    options.cube_view));
    }
}

/// The moment that effects are drawn at; of a sequence one of its later ones.
double moment_of(const Options& options) {
    const auto range = options.study == nullptr ? parse_frames(options.frames).range : std::nullopt;
    return range && options.seconds == 0 ? range->last / options.frame_rate : options.seconds;
}

/// Effects that --without takes out again, and of the others what their values leave idle; in a
/// window these change.
void add_effects(std::vector<std::string>& lines, const Options& options) {
    for (const EffectUse& use : options.effects) {
        const std::string option = fmt::format("--effect {}", use.effect->name);
        if (is_without(options, use.effect->name)) {
            lines.push_back(
                unused_text(option, fmt::format("--without {} switches it off", use.effect->name)));
            continue;
        }
        const EffectUse usual = usual_use(*use.effect);
        const bool has_idle = use.effect->idle_parameter != nullptr && strength_of(use) != 0 &&
                              !opens_window(options);
        for (std::size_t i = 0; has_idle && i < use.values.size(); ++i) {
            const std::string_view why =
                use.effect->idle_parameter(use.values, i, moment_of(options));
            if (!why.empty() && use.values[i] != usual.values[i]) {
                lines.push_back(
                    unused_text(fmt::format("{}:{}", option, use.effect->parameters[i].name), why));
            }
        }
    }
}

/// What a part of the frame needs of a run so as to be there without --without.
struct PartNeeds {
    Effect part;
    Needs needs;
};
constexpr PartNeeds part_needs[] = {
    {Effect::lights, Need::scene},
    {Effect::shadows, Need::scene | Need::lights | Need::casting_light},
    {Effect::environment, Need::scene},
    {Effect::occlusion, Need::scene},
    {Effect::specular_aa, Need::scene},
    {Effect::floor, Need::scene},
    {Effect::bloom, Need::light | Need::bloom},
    {Effect::tonemap, Need::light},
    {Effect::looks, Need::look},
    {Effect::names, Needs::nothing()},
};
static_assert(std::size(part_needs) == effects.size());

/// Why this part would not be there anyhow; empty: it would.
std::string why_no_part(const EffectInfo& info, const OptionInRun& in) {
    const PartNeeds& row = part_needs[static_cast<std::size_t>(info.effect)];
    if (const NeedRow* const missing = first_missing(row.needs, in)) {
        return why_not_met(*missing, in);
    }
    if (info.effect == Effect::floor && !in.input->scene->floor) {
        return "no floor was put under the scene";
    }
    const Compare& compare = *in.settings->compare;
    return info.effect == Effect::names && !compare.shows_one && &compare != &compare_side
               ? "the two sides are not seen"
               : "";
}

/// Whether an effect would be in use but for --without.
bool is_wanted(const PostEffect& effect, const Options& options, const KnownInput& input) {
    const bool is_usual =
        effect.usual_for_scenes &&
        options.fxaa.value_or(input.scene != nullptr && usual_finish(options.input).is_antialiased);
    const bool is_focused = effect.name == "depth-of-field" && !options.focus_at.empty();
    return is_usual || is_focused || use_of(options.effects, effect) != nullptr;
}

/// Parts and effects that would not be there anyhow.
void add_without(std::vector<std::string>& lines, const Options& options, const KnownInput& input,
                 const FrameSettings& settings) {
    for (const std::string& name : options.without) {
        const std::string option = fmt::format("--without {}", name);
        const EffectInfo* const part = lutlib::find_named(effects, name);
        const PostEffect* const effect = post_effect_named(name);
        const std::string why =
            part != nullptr ? why_no_part(*part, {options, option, &input, &settings})
            : effect != nullptr && !is_wanted(*effect, options, input) ? "it is not in use"
                                                                       : "";
        if (!why.empty()) {
            lines.push_back(unused_text(option, why));
        }
    }
}

/// Controls that the lights, as the options leave them, have not.
void add_lights(std::vector<std::string>& lines, const Options& options, const Scene& scene,
                bool shadows_fall) {
    std::vector<PointLight> lights = scene.lights;
    std::vector<LightEdit> edits;
    for (const std::string& text : options.lights) {
        edits.push_back(edit_light(lights, text));
    }
    for (const LightEdit& edit : edits) {
        const PointLight& light = lights[edit.light];
        const std::string_view why = idle_because(*edit.control, light, shadows_fall);
        if (!why.empty()) {
            lines.push_back(unused_text(
                fmt::format("--light {}.{}", light_name(light, edit.light), edit.control->name),
                why));
        }
    }
}

OptionInRun in_run(const Options& options, const OptionNeeds& option) {
    return {.options = options, .name = option.name};
}

template <class Rows>
void add(std::vector<OptionNeeds>& out, const Rows& rows) {
    for (const auto& row : rows) {
        // Tables that only this program has say dashes and other names too.
        if constexpr (std::is_same_v<decltype(row.flag), const char*>) {
            out.push_back({main_name(row.flag), row.needs});
        } else {
            out.push_back({fmt::format("--{}", row.flag), row.needs});
        }
    }
}

} // namespace

std::string main_name(std::string_view flag) {
    // Of "--engine,--engine-b" the last, but neither a letter nor what switches off.
    std::string_view out;
    for (std::size_t at = 0; at <= flag.size();) {
        const std::size_t end = std::min(flag.find(',', at), flag.size());
        const std::string_view name = flag.substr(at, end - at);
        out = out.empty() || name.starts_with("--") ? name : out;
        at = end + 1;
    }
    return std::string(out);
}

std::vector<OptionNeeds> option_needs() {
    std::vector<OptionNeeds> out;
    add(out, option_rows());
    add(out, picture_choices());
    add(out, picture_numbers());
    add(out, picture_option_rows());
    add(out, option_lists());
    add(out, option_choices());
    add(out, camera_numbers());
    add(out, surroundings_numbers());
    add(out, cube_numbers());
    add(out, cube_switches());
    return out;
}

std::vector<std::string> unused_options(const Options& options) {
    std::vector<std::string> out;
    for (const OptionNeeds& option : option_needs()) {
        const OptionInRun in = in_run(options, option);
        const NeedRow* const missing =
            is_given(options, option.name) ? first_missing(option.needs, in) : nullptr;
        if (missing != nullptr) {
            out.push_back(unused_text(option.name, why_not_met(*missing, in)));
        }
    }
    add_bare_cube(out, options);
    if (const bool has_frame = options.cube_view.empty() && !options.list;
        has_frame || options.study != nullptr) {
        add_effects(out, options);
    }
    return out;
}

std::vector<std::string> unused_options(const Options& options, const KnownInput& input,
                                        const FrameSettings& settings) {
    std::vector<std::string> out;
    for (const OptionNeeds& option : option_needs()) {
        OptionInRun in = in_run(options, option);
        if (!is_given(options, option.name) || first_missing(option.needs, in) != nullptr) {
            continue; // not said, or said already
        }
        in.input = &input;
        in.settings = &settings;
        if (const NeedRow* const missing = first_missing(option.needs, in)) {
            out.push_back(unused_text(option.name, why_not_met(*missing, in)));
        }
    }
    add_without(out, options, input, settings);
    if (input.scene != nullptr && !settings.without.has(Effect::lights)) {
        add_lights(out, options, *input.scene, !settings.without.has(Effect::shadows));
    }
    return out;
}

std::string unused_option(const std::string& line) {
    return line.substr(0, line.find(says_unused));
}

std::vector<AskedPart> asked_parts(const Options& options) {
    std::vector<AskedPart> out;
    for (const EffectUse& use : options.effects) {
        if (!is_without(options, use.effect->name)) {
            out.push_back(
                {std::string(use.effect->name), fmt::format("--effect {}", use.effect->name)});
        }
    }
    for (const OptionNeeds& option : option_needs()) {
        const OptionInRun in = in_run(options, option);
        if (!is_given(options, option.name) || first_missing(option.needs, in) != nullptr) {
            continue;
        }
        for (const NeedRow& row : need_rows()) {
            if (option.needs.has(row.need) && !row.part.empty() &&
                (row.asks == nullptr || row.asks(in))) {
                out.push_back({std::string(row.part), option.name});
            }
        }
    }
    return out;
}

std::string not_in_light(const Options& options, const FrameSettings& settings) {
    std::vector<std::string> missing;
    if (is_any_given(options, "--bloom")) {
        missing.emplace_back("the bloom");
    }
    if (is_given(options, "--tonemap")) {
        missing.emplace_back("the tone map");
    }
    if (names_look(options.look_a) || names_look(options.look_b)) {
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
