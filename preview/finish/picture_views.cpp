#include "preview/finish/picture_views.h"

#include <algorithm>

namespace preview {

namespace {

constexpr std::size_t named_bands = static_cast<std::size_t>(
    std::count_if(level_bands.begin(), level_bands.end(),
                  [](const LevelBand& band) { return !band.text.empty(); }));

constexpr std::array<LegendEntry, named_bands> levels = [] {
    std::array<LegendEntry, named_bands> out{};
    std::size_t count = 0;
    for (const LevelBand& band : level_bands) {
        if (!band.text.empty()) {
            out[count++] = {band.color, band.text};
        }
    }
    return out;
}();

constexpr LegendEntry zebra[] = {{{1, 1, 1}, "LUMA FROM THE LEVEL ON"}};

// The colours by their place: whiter than white before the looks and by them, then blacker.
constexpr LegendEntry clipping[] = {
    {{0.98F, 0.85F, 0.10F}, "WHITE BEFORE THE LOOK"},
    {{0.90F, 0.10F, 0.10F}, "WHITE BY THE LOOK"},
    {{0.10F, 0.75F, 0.75F}, "BLACK BEFORE THE LOOK"},
    {{0.15F, 0.30F, 0.95F}, "BLACK BY THE LOOK"},
};

constexpr LegendEntry gamut[] = {
    {{0.98F, 0.60F, 0.10F}, "OUTSIDE BEFORE THE LOOK"},
    {{0.90F, 0.10F, 0.75F}, "OUTSIDE BY THE LOOK"},
};

constexpr LegendEntry red[] = {{{1, 0, 0}, "RED"}};
constexpr LegendEntry green[] = {{{0, 1, 0}, "GREEN"}};
constexpr LegendEntry blue[] = {{{0, 0, 1}, "BLUE"}};
constexpr LegendEntry luma[] = {{{1, 1, 1}, "LUMA"}};
constexpr LegendEntry saturation[] = {{{1, 1, 1}, "SATURATION"}};

constexpr PictureView views[] = {
    {.name = "picture", .label = "the picture itself", .shader = ""},
    {.name = "false-color",
     .label = "false colour: black, 18 % grey, the stop above it, white",
     .shader = "view_false_color",
     .legend = levels},
    {.name = "zebra",
     .label = "stripes where the luma is high (--zebra-level)",
     .shader = "view_zebra",
     .legend = zebra},
    {.name = "clipping",
     .label = "channels at their ends, before the looks and by them",
     .shader = "view_clipping",
     .reads_before = true,
     .legend = clipping},
    {.name = "gamut",
     .label = "colours that the display cannot show, before the looks and by them",
     .shader = "view_gamut",
     .reads_before = true,
     .legend = gamut},
    {.name = "red", .label = "the red channel", .shader = "view_red", .legend = red},
    {.name = "green", .label = "the green channel", .shader = "view_green", .legend = green},
    {.name = "blue", .label = "the blue channel", .shader = "view_blue", .legend = blue},
    {.name = "luma", .label = "luma by Rec. 709's weights", .shader = "view_luma", .legend = luma},
    {.name = "saturation",
     .label = "saturation of the codes as HSV has it",
     .shader = "view_saturation",
     .legend = saturation},
};

} // namespace

std::span<const PictureView> picture_views() {
    return views;
}

const PictureView* picture_view_named(std::string_view name) {
    return lutlib::find_named(views, name);
}

int index_of(const PictureView& row) {
    return static_cast<int>(&row - std::begin(views));
}

} // namespace preview
