#include "preview/finish/picture_settings.h"

#include "preview/finish/setting_needs.h"

#include <fmt/format.h>

namespace preview {

namespace {

using S = PictureSettings;

std::span<const Compare> compare_rows() {
    return compares;
}

constexpr NumberRow<S> numbers[] = {
    {.flag = "exposure",
     .label = "Exposure",
     .unit = "stops",
     .help = "Stops, added to the scene's",
     .needs = Need::frame,
     .min = -20,
     .max = 20,
     .slider_min = -8,
     .slider_max = 8,
     .of = [](S& s) -> float& { return s.exposure; }},
    {.flag = "occlusion-strength",
     .label = "Occlusion strength",
     .help = "Ambient occlusion, times the scene's; 0: none",
     .needs = Need::frame | Need::occlusion | Need::scene,
     .max = 2,
     .of = [](S& s) -> float& { return s.occlusion.strength; }},
    {.flag = "occlusion-radius",
     .label = "Occlusion radius",
     .unit = "m",
     .help = "Surfaces farther away hide nothing of the surroundings",
     .needs = Need::frame | Need::occlusion | Need::scene,
     .min = 0.01,
     .max = 10,
     .slider_min = 0.05,
     .slider_max = 2,
     .is_logarithmic = true,
     .of = [](S& s) -> float& { return s.occlusion.radius; }},
    {.flag = "occlusion-samples",
     .label = "Occlusion samples",
     .help = "Directions in which a cell of pixels looks for them",
     .needs = Need::frame | Need::occlusion | Need::scene,
     .min = 1,
     .max = 64,
     .of = [](S& s) -> float& { return s.occlusion.samples; }},
    {.flag = "bloom-strength",
     .label = "Bloom strength",
     .help = "Share of the light that blooms; by default the method's own",
     .needs = Need::frame | Need::bloom_part | Need::light | Need::bloom,
     .of = [](S& s) -> float& { return s.bloom_settings.strength; },
     .own = [](const S& s) { return s.bloom != nullptr ? s.bloom->strength : 0; },
     .own_name = "the method's own"},
    {.flag = "bloom-threshold",
     .label = "Bloom threshold",
     .help = "Brightness above which light blooms; 0: all light",
     .needs = Need::frame | Need::bloom_part | Need::light | Need::bloom,
     .max = 65504,
     .slider_max = 16,
     .is_logarithmic = true,
     .of = [](S& s) -> float& { return s.bloom_settings.threshold; }},
    {.flag = "bloom-knee",
     .label = "Bloom knee",
     .help = "Half width of the soft step about the threshold",
     .needs = Need::frame | Need::bloom_part | Need::light | Need::bloom,
     .max = 65504,
     .slider_max = 4,
     .of = [](S& s) -> float& { return s.bloom_settings.knee; }},
    {.flag = "bloom-radius",
     .label = "Bloom radius",
     .help = "Scales the bloom's width",
     .needs = Need::frame | Need::bloom_part | Need::light | Need::bloom,
     .min = 0.05,
     .max = 8,
     .is_logarithmic = true,
     .of = [](S& s) -> float& { return s.bloom_settings.radius; }},
    {.flag = "split",
     .label = "Split",
     .help = "Where the line stands, of the way across the picture",
     .needs = Need::frame | Need::split,
     .of = [](S& s) -> float& { return s.split; }},
    {.flag = "split-angle",
     .label = "Split turned by",
     .unit = "degrees",
     .help = "Direction of the split, clockwise: 0 has A left, 90 above",
     .needs = Need::frame | Need::split,
     .max = 360,
     .of = [](S& s) -> float& { return s.split_angle; }},
    {.flag = "box-x",
     .label = "Box from, across",
     .help = "Left side of the box of a comparison, of the width",
     .needs = Need::frame | Need::box,
     .of = [](S& s) -> float& { return s.box_x; }},
    {.flag = "box-y",
     .label = "Box from, down",
     .help = "Its upper side, of the height",
     .needs = Need::frame | Need::box,
     .of = [](S& s) -> float& { return s.box_y; }},
    {.flag = "box-width",
     .label = "Box width",
     .help = "Of the width",
     .needs = Need::frame | Need::box,
     .of = [](S& s) -> float& { return s.box_width; }},
    {.flag = "box-height",
     .label = "Box height",
     .help = "Of the height",
     .needs = Need::frame | Need::box,
     .of = [](S& s) -> float& { return s.box_height; }},
    {.flag = "heat-scale",
     .label = "Heat map to dE2000",
     .help = "dE2000 at the end of the heat map; by default the 99th percentile, up to the next 4",
     .needs = Need::frame | Need::picture | Need::heat_map,
     .min = 4,
     .max = 96,
     .of = [](S& s) -> float& { return s.heat_scale; },
     .own = [](const S&) { return usual_heat_scale; },
     .own_name = "until the 99th percentile is known"},
    {.flag = "zebra-level",
     .label = "Zebra from",
     .help = "Luma from which --view zebra has stripes, 1 is white",
     .needs = Need::frame | Need::zebra,
     .of = [](S& s) -> float& { return s.zebra_level; }},
    {.flag = "zoom",
     .label = "Zoom",
     .help = "Pixels of the output to one of the picture, 1 for 1:1; 0: all of it is seen",
     .needs = Need::frame | Need::whole_picture,
     .max = most_zoom,
     .of = [](S& s) -> float& { return s.zoom.scale; }},
    {.flag = "zoom-x",
     .label = "Zoom at, across",
     .help = "What of the picture is in the middle, of its width; for --zoom",
     .needs = Need::frame | Need::zoom,
     .of = [](S& s) -> float& { return s.zoom.x; }},
    {.flag = "zoom-y",
     .label = "Zoom at, down",
     .help = "The same of its height",
     .needs = Need::frame | Need::zoom,
     .of = [](S& s) -> float& { return s.zoom.y; }},
};

constexpr ChoiceRow<S> choices[] = {
    choice_of<S, &S::shadow_filter, shadow_filters>(
        "shadow-filter", "Shadow filter", "filter of shadow maps", "Filters of shadow maps",
        "By how many texels of a shadow map a shadow is averaged",
        Need::frame | Need::shadows | Need::scene | Need::casting_light),
    {.flag = "occlusion-resolution",
     .label = "Occlusion resolution",
     .kind = "resolution of the ambient occlusion",
     .title = "Resolutions of the ambient occlusion",
     .help = "How many pixels share an ambient occlusion",
     .needs = Need::frame | Need::occlusion | Need::scene,
     .options = [] { return options_of(occlusion_resolutions()); },
     .chosen =
         [](const S& s) {
             return static_cast<std::size_t>(s.occlusion.resolution -
                                             occlusion_resolutions().data());
         },
     .choose =
         [](S& s, std::size_t option) {
             s.occlusion.resolution = &occlusion_resolutions()[option];
         }},
    choice_of<S, &S::tonemap, tonemaps>("tonemap", "Tone map", "tone map", "Tone maps",
                                        "Tone map; some scenes have their own",
                                        Need::frame | Need::tonemap | Need::light),
    choice_of<S, &S::bloom, blooms>("bloom", "Bloom", "bloom", "Blooms",
                                    "Bloom; some scenes have their own",
                                    Need::frame | Need::bloom_part | Need::light),
    choice_of<S, &S::compare, compare_rows>(
        "compare", "Compare", "comparison", "Comparisons",
        "What is shown of the looks; by default a, or split when --b is given", Need::frame),
    choice_of<S, &S::picture_view, picture_views>(
        "view", "See", "view of the picture", "Views of the picture",
        "How the finished picture is looked at, with a legend",
        Need::frame | Need::no_scope | Need::no_intermediate | Need::no_heat_map),
    {.flag = "magnify",
     .label = "Magnified",
     .kind = "way to magnify",
     .title = "Ways to magnify",
     .help = "How a picture fills the pixels between that --zoom makes",
     .needs = Need::frame | Need::zoom,
     .options = [] { return options_of(magnifiers); },
     .chosen =
         [](const S& s) { return static_cast<std::size_t>(s.zoom.magnifier - magnifiers.data()); },
     .choose = [](S& s, std::size_t option) { s.zoom.magnifier = &magnifiers[option]; }},
};

} // namespace

std::span<const NumberRow<S>> picture_numbers() {
    return numbers;
}

std::span<const ChoiceRow<S>> picture_choices() {
    return choices;
}

const NumberRow<S>& picture_number(std::string_view flag) {
    return row_of(picture_numbers(), flag);
}

const ChoiceRow<S>& picture_choice(std::string_view flag) {
    return row_of(picture_choices(), flag);
}

std::string settings_text(const PictureSettings& settings) {
    std::string out;
    for (const ChoiceRow<S>& row : choices) {
        out += fmt::format("setting   {} {}\n", row.flag, row.options()[row.chosen(settings)].name);
    }
    return out + settings_lines(picture_numbers(), settings);
}

} // namespace preview
