#include "preview/cli/option_needs.h"

#include "lutlib/io/file.h"
#include "preview/cli/sequence.h"
#include "preview/effects/effect.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview {

namespace {

using In = OptionInRun;
using When = NeedRow::When;

bool is_study(const In& in) {
    return in.options.study != nullptr;
}

bool is_frame(const In& in) {
    return is_study(in) || (in.options.cube_view.empty() && !in.options.list);
}

std::string why_no_frame(const In& in) {
    return in.options.list ? "--list prints its tables and nothing else"
                           : fmt::format("--cube-view {} draws that side's look and nothing else",
                                         in.options.cube_view);
}

/// Of a report, which is of one picture.
bool reports_on_b(const In& in) {
    return is_study(in) && in.options.study->writes_page && names_look(in.options.look_b);
}

std::string why_not_side(const In& in) {
    return is_frame(in) ? "a report is of one picture, that of side B" : why_no_frame(in);
}

std::string why_no_picture(const In& in) {
    return fmt::format("{} writes no picture", is_study(in) ? in.options.study->name : "--list");
}

bool is_window(const In& in) {
    return opens_window(in.options);
}

bool has_look(const In& in) {
    return names_look(in.options.look_a) || names_look(in.options.look_b);
}

bool has_scope(const In& in) {
    return in.options.frame.scope != nullptr;
}

bool has_encoded_scope(const In& in) {
    return has_scope(in) && !in.options.scope_encoding.empty();
}

bool compares_by(const In& in, const Compare& compare) {
    return compare_of(in.options) == &compare || is_window(in);
}

bool is_sequence(const In& in) {
    return parse_frames(in.options.frames).range.has_value();
}

/// Whether the surroundings have the number that the option sets.
bool has_number(const SurroundingsInfo& kind, const In& in) {
    return std::any_of(
        kind.numbers.begin(), kind.numbers.end(),
        [&](const NumberRow<Surroundings>& own) { return in.name.substr(2) == own.flag; });
}

SurroundingsKind kind_of(const In& in) {
    return surroundings_of(in.options, *in.input->scene).kind;
}

std::string why_not_kind(const In& in) {
    std::vector<std::string> kinds;
    for (const SurroundingsInfo& kind : surroundings_kinds()) {
        if (has_number(kind, in)) {
            kinds.push_back(fmt::format(
                "--surroundings {}", kind.kind == SurroundingsKind::picture ? "FILE" : kind.name));
        }
    }
    return "it is for " + enumerated(kinds, "or");
}

bool has_casting_light(const In& in) {
    const std::vector<PointLight> lights = lights_of(in.options, *in.input->scene);
    const bool has_sun =
        kind_of(in) == SurroundingsKind::sky && !in.settings->without.has(Effect::environment);
    return has_sun || std::any_of(lights.begin(), lights.end(), [](const PointLight& light) {
               return light.is_on && light.casts_shadow;
           });
}

/// Whether an effect has a rate at which it changes.
bool changes(const EffectUse& use) {
    auto* const idle = use.effect->idle_parameter;
    for (std::size_t i = 0; idle != nullptr && i < use.values.size(); ++i) {
        if (idle(use.values, i, 1).empty() && !idle(use.values, i, 0).empty() &&
            std::get<double>(use.values[i]) != 0) {
            return strength_of(use) != 0;
        }
    }
    return false;
}

bool has_motion(const In& in) {
    const SceneInfo* const scene = scene_named(in.options.input);
    return (scene != nullptr && scene->animate != nullptr) ||
           (in.input->scene != nullptr && kind_of(in) == SurroundingsKind::noise) ||
           std::any_of(in.settings->effects.begin(), in.settings->effects.end(), changes);
}

/// --bloom none and a strength of 0 ask for none.
bool asks_for_bloom(const In& in) {
    const bool may_switch_off = in.name == "--bloom" || in.name == "--bloom-strength";
    return !may_switch_off || (in.options.frame.bloom != bloom_named("none") &&
                               in.options.frame.bloom_settings.strength != 0);
}

bool asks_for_occlusion(const In& in) {
    return in.name != "--occlusion-strength" || in.options.frame.occlusion.strength > 0;
}

constexpr NeedRow need_table[] = {
    {.need = Need::frame, .when = When::always, .is_met = is_frame, .tell = why_no_frame},
    {.need = Need::side_a,
     .when = When::always,
     .is_met =
         [](const In& in) {
             return is_frame(in) ? !reports_on_b(in) : in.options.cube_view == "a";
         },
     .tell = why_not_side},
    {.need = Need::side_b,
     .when = When::always,
     .is_met = [](const In& in) { return is_frame(in) || in.options.cube_view == "b"; },
     .tell = why_not_side},
    {.need = Need::picture,
     .when = When::always,
     .is_met = [](const In& in) { return !is_study(in); },
     .tell = why_no_picture},
    {.need = Need::file,
     .when = When::always,
     .is_met =
         [](const In& in) {
             return is_study(in) ? in.options.study->writes_page : !in.options.list;
         },
     .tell = why_no_picture},
    {.need = Need::listing,
     .when = When::always,
     .is_met = [](const In& in) { return !is_study(in); },
     .tell =
         [](const In& in) { return fmt::format("{} prints no tables", in.options.study->name); }},
    {.need = Need::report,
     .when = When::always,
     .is_met = [](const In& in) { return is_study(in) && in.options.study->writes_page; },
     .why_not = "it is for 'lutpreview report'"},
    {.need = Need::window, .when = When::always, .is_met = is_window, .why_not = "no window opens"},
    {.need = Need::cube_view,
     .when = When::always,
     .is_met =
         [](const In& in) {
             return (!is_study(in) && !in.options.cube_view.empty()) || is_window(in);
         },
     .why_not = "no --cube-view is drawn"},
    {.need = Need::metered_file,
     .is_met = [](const In& in) { return !is_window(in); },
     .why_not = "the panel View has a meter; this one is for a picture"},
    {.need = Need::terminal,
     .is_met = [](const In& in) { return !is_window(in); },
     .why_not = "the window prints nothing"},
    {.need = Need::look_a,
     .is_met = [](const In& in) { return names_look(in.options.look_a) || is_window(in); },
     .why_not = "side A has no look"},
    {.need = Need::look_b,
     .is_met = [](const In& in) { return names_look(in.options.look_b) || is_window(in); },
     .why_not = "side B has no look"},
    {.need = Need::look,
     .is_met = [](const In& in) { return has_look(in) || is_window(in); },
     .why_not = "neither side has a look"},
    {.need = Need::codes,
     .is_met = [](const In& in) { return has_look(in) || has_encoded_scope(in) || is_window(in); },
     .why_not = "neither side has a look"},
    {.need = Need::still,
     .is_met = [](const In& in) { return shows_stills(in.options); },
     .why_not = "neither side has a still"},
    {.need = Need::scope,
     .is_met = [](const In& in) { return has_scope(in) || is_window(in); },
     .why_not = "no --scope is shown"},
    {.need = Need::scope_levels,
     .is_met =
         [](const In& in) {
             return !has_scope(in) || has_levels(*in.options.frame.scope) || is_window(in);
         },
     .why_not = "a vectorscope counts the codes as they are shown"},
    {.need = Need::scope_brightness,
     .is_met = [](const In& in) { return !writes_counts(in.options); },
     .why_not = "a .csv has the counts themselves"},
    {.need = Need::scope_encoding,
     .is_met = [](const In& in) { return has_encoded_scope(in) || is_window(in); },
     .why_not = "no --scope-encoding is given"},
    {.need = Need::frame_count,
     .is_met = [](const In& in) { return in.options.timings || is_sequence(in); },
     .why_not = "--timings takes it"},
    {.need = Need::sequence,
     .is_met = is_sequence,
     .why_not = "--frames names no sequence, as 0-119 does"},
    {.need = Need::output,
     .is_met = [](const In& in) { return !in.options.output.empty(); },
     .why_not = "no picture is written; -o names one"},
    {.need = Need::light_output,
     .is_met = [](const In& in) { return output_holds_light(in.options); },
     .why_not = "it is for an output of .exr or .hdr"},
    {.need = Need::whole_picture,
     .is_met =
         [](const In& in) {
             return (!has_scope(in) && !in.options.frame.shows_intermediate()) || is_window(in);
         },
     .why_not = "it is for the picture, not for what --debug-view and --scope show"},
    {.need = Need::no_scope,
     .is_met = [](const In& in) { return !has_scope(in) || is_window(in); },
     .why_not = "--scope measures the picture itself"},
    {.need = Need::no_intermediate,
     .is_met = [](const In& in) { return !in.options.frame.shows_intermediate() || is_window(in); },
     .why_not = "it is for the picture, not for what --debug-view shows"},
    {.need = Need::no_heat_map,
     .is_met =
         [](const In& in) {
             return compare_of(in.options) != &compare_difference || is_window(in);
         },
     .why_not = "a heat map (--compare diff) is no picture to look at"},
    {.need = Need::split,
     .is_met = [](const In& in) { return compares_by(in, compare_split); },
     .why_not = "it is for --compare split"},
    {.need = Need::box,
     .is_met = [](const In& in) { return compares_by(in, compare_box); },
     .why_not = "it is for --compare box"},
    {.need = Need::heat_map,
     .is_met = [](const In& in) { return compares_by(in, compare_difference); },
     .why_not = "it is for --compare diff"},
    {.need = Need::zebra,
     .is_met =
         [](const In& in) {
             return in.options.frame.picture_view == picture_view_named("zebra") || is_window(in);
         },
     .why_not = "it is for --view zebra"},
    {.need = Need::zoom,
     .is_met = [](const In& in) { return in.options.frame.zoom.scale > 0 || is_window(in); },
     .why_not = "all of the picture is seen; --zoom shows a part"},
    {.need = Need::lights, .without = "lights"},
    {.need = Need::shadows, .without = "shadows"},
    {.need = Need::occlusion,
     .without = "occlusion",
     .part = "ambient occlusion",
     .asks = asks_for_occlusion},
    {.need = Need::bloom_part, .without = "bloom", .part = "bloom", .asks = asks_for_bloom},
    {.need = Need::tonemap, .without = "tonemap", .part = "tone map"},
    {.need = Need::depth_of_field, .without = "depth-of-field", .part = "depth-of-field"},
    {.need = Need::fxaa,
     .is_met =
         [](const In& in) {
             return !in.options.fxaa.value_or(true) || !is_without(in.options, "fxaa");
         },
     .without = "fxaa",
     .part = "fxaa",
     .asks = [](const In& in) { return in.options.fxaa.value_or(false); }},
    {.need = Need::dither,
     .part = "dither",
     .asks = [](const In& in) { return in.options.dither.value_or(false); }},
    {.need = Need::scene,
     .when = When::input,
     .is_met = [](const In& in) { return in.input->scene != nullptr; },
     .why_not = "a picture is shown"},
    {.need = Need::surroundings_kind,
     .when = When::input,
     .is_met =
         [](const In& in) {
             return has_number(surroundings_kinds()[static_cast<std::size_t>(kind_of(in))], in);
         },
     .tell = why_not_kind},
    {.need = Need::motion,
     .when = When::input,
     .is_met = has_motion,
     .why_not = "nothing moves: neither the scene nor an effect"},
    {.need = Need::casting_light,
     .when = When::input,
     .is_met = has_casting_light,
     .why_not = "no light casts a shadow"},
    {.need = Need::light,
     .when = When::input,
     .is_met = [](const In& in) { return !in.input->has_codes; },
     .why_not = "the picture is display-encoded already"},
    {.need = Need::light_to_write,
     .when = When::input,
     .is_met = [](const In& in) { return !in.options.exr_light || !in.input->has_codes; },
     .why_not = "the picture holds codes and no light"},
    {.need = Need::bloom,
     .when = When::input,
     .is_met = [](const In& in) { return in.settings->bloom != bloom_named("none"); },
     .why_not = "there is no bloom (--bloom none)"},
};
static_assert(std::size(need_table) == static_cast<std::size_t>(Need::count));
static_assert(std::size(need_table) <= 64, "Needs has a bit for each");

bool is_judged(const NeedRow& row, const In& in) {
    switch (row.when) {
    case When::always:
        return true;
    case When::frame:
        return is_frame(in) && !is_study(in);
    default:
        return in.input != nullptr;
    }
}

} // namespace

std::span<const NeedRow> need_rows() {
    return need_table;
}

bool is_met(const NeedRow& row, const OptionInRun& option) {
    return row.is_met != nullptr ? row.is_met(option)
                                 : row.without.empty() || !is_without(option.options, row.without);
}

std::string why_not_met(const NeedRow& row, const OptionInRun& option) {
    return row.tell != nullptr   ? row.tell(option)
           : row.without.empty() ? std::string(row.why_not)
                                 : fmt::format("--without {} switches it off", row.without);
}

const NeedRow* first_missing(Needs needs, const OptionInRun& option) {
    const auto found =
        std::find_if(std::begin(need_table), std::end(need_table), [&](const NeedRow& row) {
            return needs.has(row.need) && is_judged(row, option) && !is_met(row, option);
        });
    return found == std::end(need_table) ? nullptr : &*found;
}

bool is_without(const Options& options, std::string_view name) {
    return std::find(options.without.begin(), options.without.end(), name) != options.without.end();
}

bool names_look(const std::string& path) {
    return !path.empty() && path != "none";
}

bool output_holds_light(const Options& options) {
    const std::string extension = lutlib::io::extension_of(options.output);
    return extension == "exr" || extension == "hdr";
}

bool writes_counts(const Options& options) {
    return options.frame.scope != nullptr && lutlib::io::extension_of(options.output) == "csv";
}

std::string enumerated(const std::vector<std::string>& items, std::string_view last) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        out += i == 0                  ? items[i]
               : i + 1 == items.size() ? fmt::format(" {} {}", last, items[i])
                                       : ", " + items[i];
    }
    return out;
}

} // namespace preview
