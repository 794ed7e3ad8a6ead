#include "converter/panels/all.h"
#include "converter/panels/bands.h"
#include "converter/panels/parts.h"
#include "converter/panels/ramps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace converter {
namespace {

constexpr int gradient_columns = 128;

// Of full sRGB codes about the hues, red at both ends.
std::vector<lutlib::RgbD> hue_light() {
    const SeenLight srgb(lutlib::srgb());
    std::vector<lutlib::RgbD> out;
    for (int i = 0; i < gradient_columns; ++i) {
        const double hue = 6 * i / (gradient_columns - 1.0);
        lutlib::RgbD code;
        for (std::size_t c = 0; c < 3; ++c) {
            const double away = std::abs(hue - 2.0 * static_cast<double>(c));
            code[c] = std::clamp(2 - std::min(away, 6 - away), 0.0, 1.0);
        }
        out.push_back(srgb.of(code));
    }
    return out;
}

plot::Figure neutral_gradient(ShownLooks looks) {
    Bands bands("Gradient of the neutral axis", false);
    for (const ShownLook* look : befores(looks)) {
        bands.add(before_name(looks, *look),
                  in_srgb(neutral_codes(look->domain, gradient_columns), look->input));
    }
    for (const ShownLook& look : looks) {
        bands.add(look.name, in_srgb(images_of(look, neutral_codes(look.domain, gradient_columns)),
                                     look.output));
    }
    plot::Figure out = bands.figure();
    const bool is_one = looks.front().domain == looks.back().domain;
    const std::vector<lutlib::RgbD> ends = neutral_codes(looks.front().domain, 2);
    out.x.label = "input code value, R = G = B";
    out.x.ticks = {{0, is_one ? fmt::format("{:.3g}", ends.front().r) : "lowest"},
                   {1, is_one ? fmt::format("{:.3g}", ends.back().r) : "highest"}};
    return out;
}

plot::Figure hue_gradient(ShownLooks looks) {
    Bands bands("Gradient of hues", false);
    const std::vector<lutlib::RgbD> light = hue_light();
    bands.add("before", shown_srgb(light));
    for (const ShownLook& look : looks) {
        bands.add(look.name, in_srgb(images_of(look, codes_of_light(look, light)), look.output));
    }
    plot::Figure out = bands.figure();
    out.x.label = "hue of full sRGB colours";
    for (std::size_t i = 0; i < std::size(hue_rows); ++i) {
        out.x.ticks.push_back({static_cast<double>(i) / 6, hue_rows[i].name});
    }
    return out;
}

std::vector<plot::Figure> gradient_figures(ShownLooks looks) {
    std::vector<plot::Figure> out{neutral_gradient(looks), hue_gradient(looks)};
    for (plot::Figure& figure : out) {
        figure.is_wide = true;
    }
    return out;
}

} // namespace

const Panel panel::gradient{
    .name = "gradient",
    .label = "Gradients",
    .help = "The neutral axis over the domain, and the most saturated colours of sRGB, before and "
            "after, as an sRGB display shows them.",
    .figures = gradient_figures,
};

} // namespace converter
