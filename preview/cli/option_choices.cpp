// The options that stand under headings of their own, those that choose among rows, and those that
// may be repeated.
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/finish/setting_needs.h"
#include "preview/frame/frame.h"

namespace preview {

namespace {

using O = Options;

constexpr OptionRow picture_rows[] = {
    {.flag = "--fxaa,!--no-fxaa",
     .help = "Antialiasing; by default on for scenes but the chart, off for pictures",
     .needs = Need::frame | Need::fxaa,
     .of = [](O& o) -> std::optional<bool>& { return o.fxaa; }},
    {.flag = "--dither,!--no-dither",
     .help = "Spread the rounding to 8 bits, so that smooth ramps show no contours; by default on "
             "in the window and off without it",
     .needs = Need::frame | Need::picture | Need::dither,
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

constexpr ChoiceRow<Options> choice_rows[] = {
    {.flag = "exr",
     .label = "What .exr holds",
     .kind = "content of .exr",
     .title = "Contents of .exr and .hdr",
     .help = "What .exr and .hdr hold, by default light, of a picture that holds codes the picture",
     .needs = Need::frame | Need::picture | Need::light_output | Need::whole_picture |
              Need::light_to_write,
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
     .needs = Need::look | Need::light,
     .options = [] { return options_of(look_at_rows()); },
     .choose = [](O& o, std::size_t i) { choose(o.look_at, look_at_rows(), i); }},
    {.flag = "raster",
     .label = "Rasteriser",
     .kind = "rasteriser",
     .title = "Rasterisers",
     .help = "Rasteriser",
     .needs = Need::frame | Need::scene,
     .options = [] { return options_of(rasters()); },
     .choose = [](O& o, std::size_t i) { choose(o.raster, rasters(), i); }},
    {.flag = "debug-view",
     .label = "View",
     .kind = "debug view",
     .title = "Views",
     .help = "Show an intermediate",
     .needs = Need::frame | Need::picture,
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
     .needs = Need::frame | Need::picture,
     .options = [] { return options_of(scope_rows()); },
     .choose = [](O& o, std::size_t i) { choose(o.frame.scope, scope_rows(), i); }},
    {.flag = "scope-side",
     .label = "Side of the scope",
     .kind = "side of a scope",
     .title = "Sides of a scope",
     .help = "What the scope measures",
     .needs = Need::frame | Need::picture | Need::scope,
     .options = [] { return options_of(scope_side_rows()); },
     .choose = [](O& o, std::size_t i) { choose(o.frame.scope_side, scope_side_rows(), i); }},
    {.flag = "scope-scale",
     .label = "Scale of the scope",
     .kind = "scale of a scope",
     .title = "Scales of a scope",
     .help = "How counts become brightness or height",
     .needs = Need::frame | Need::picture | Need::scope | Need::scope_brightness,
     .options = [] { return options_of(scope_scales); },
     .choose = [](O& o,
                  std::size_t i) { o.frame.scope_logarithmic = scope_scales[i].logarithmic; }},
    {.flag = "scope-gain",
     .label = "Gain of the scope",
     .kind = "gain of a scope",
     .title = "Gains of a scope",
     .help = "How often counts are multiplied before that",
     .needs = Need::frame | Need::picture | Need::scope | Need::scope_brightness,
     .options = [] { return options_of(scope_gains); },
     .choose = [](O& o, std::size_t i) { o.frame.scope_gain = &scope_gains[i]; }},
};

constexpr ListRow list_rows[] = {
    {.flag = "--effect",
     .help = "Lays an effect over the picture, as vignette or vignette:strength=0.5,angle=90; "
             "--list has them. May be repeated",
     .needs = Need::frame,
     .type = "NAME[:PARAMETER=VALUE,...]",
     .take = [](O& o, const std::string& text) { put_use(o.effects, parse_use(text)); }},
    {.flag = "--without",
     .help = "Parts of the frame and effects to switch off, with commas between them, from --list",
     .needs = Need::frame,
     .type = "PARTS",
     .between = ',',
     .take = [](O& o, const std::string& name) { o.without.push_back(name); }},
    {.flag = "--light",
     .help = "Changes a light, as sun.intensity=2 or 1.color=1,0.5,0; --list has the controls. May "
             "be repeated",
     .needs = Need::frame | Need::lights,
     .type = "LIGHT.CONTROL=VALUE",
     .take = [](O& o, const std::string& text) { o.lights.push_back(text); }},
};

} // namespace

std::span<const OptionRow> picture_option_rows() {
    return picture_rows;
}

std::span<const ChoiceRow<Options>> option_choices() {
    return choice_rows;
}

std::span<const ListRow> option_lists() {
    return list_rows;
}

} // namespace preview
