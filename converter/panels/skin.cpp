#include "converter/panels/all.h"
#include "converter/panels/bands.h"
#include "converter/panels/parts.h"
#include "lutlib/color/difference.h"
#include "lutlib/color/swatches.h"

#include <fmt/core.h>

#include <cmath>

namespace converter {
namespace {

struct NamedLight {
    std::vector<std::string> names;
    std::vector<lutlib::RgbD> light; ///< linear Rec.709
};

NamedLight monk_tones() {
    const SeenLight srgb(lutlib::srgb());
    NamedLight out;
    for (const lutlib::Swatch& swatch : lutlib::skin_tones) {
        out.names.emplace_back(swatch.name);
        out.light.push_back(srgb.of(
            lutlib::RgbD{swatch.srgb[0] / 255.0, swatch.srgb[1] / 255.0, swatch.srgb[2] / 255.0}));
    }
    return out;
}

// CIE 15:2004, 8.2.1: L*, a* and b* to tristimulus values under D65.
lutlib::RgbD light_of_lab(const std::array<double, 3>& lab) {
    const double fy = (lab[0] + 16) / 116;
    const auto value = [](double f) {
        return f > 6.0 / 29 ? f * f * f : (f - 16.0 / 116) * 3 * (6.0 / 29) * (6.0 / 29);
    };
    const lutlib::RgbD white = xyz_of(lutlib::white_d65);
    const lutlib::RgbD xyz{white.r * value(fy + lab[1] / 500), white.g * value(fy),
                           white.b * value(fy - lab[2] / 200)};
    return inverse(rgb_to_xyz(lutlib::rec709)) * xyz;
}

NamedLight measured_tones() {
    NamedLight out;
    for (const lutlib::LabSwatch& swatch : lutlib::measured_skins) {
        out.names.emplace_back(swatch.name);
        out.light.push_back(light_of_lab(swatch.lab));
    }
    return out;
}

std::string distance_text(lutlib::RgbD before, lutlib::RgbD after) {
    const double distance = lutlib::delta_e_2000(saturate(before), after);
    return std::isfinite(distance) ? fmt::format("{:.{}f}", distance, distance < 9.95 ? 1 : 0)
                                   : "-";
}

plot::Figure skin_figure(ShownLooks looks, const char* title, const char* x_label,
                         const NamedLight& tones) {
    Bands bands(title, true);
    const std::vector<lutlib::RgbD> before = shown_srgb(tones.light);
    bands.add("before", before, tones.names);
    for (const ShownLook& look : looks) {
        std::vector<lutlib::RgbD> after =
            in_srgb(images_of(look, codes_of_light(look, tones.light)), look.output);
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < after.size(); ++i) {
            // A display shows no others.
            if (std::isfinite(largest_magnitude(after[i]))) {
                after[i] = saturate(after[i]);
            }
            texts.push_back(distance_text(before[i], after[i]));
        }
        bands.add(look.name, after, tones.names, texts);
    }
    plot::Figure out = bands.figure();
    out.x.label = x_label;
    out.y.label = "below each its dE2000 from before";
    for (std::size_t i = 0; i < tones.names.size(); ++i) {
        out.x.ticks.push_back(
            {(static_cast<double>(i) + 0.5) / static_cast<double>(tones.names.size()),
             std::to_string(i + 1)});
    }
    return out;
}

std::vector<plot::Figure> skin_figures(ShownLooks looks) {
    return {skin_figure(looks, "Skin tones of the Monk scale", "tone, from light to dark",
                        monk_tones()),
            skin_figure(looks, "Measured skin tones", "means of people, from dark to light",
                        measured_tones())};
}

} // namespace

const Panel panel::skin{
    .name = "skin",
    .label = "Skin tones",
    .help = "The ten tones of the Monk Skin Tone Scale and means of measured skin (Xiao et al. "
            "2017), before and after, as an sRGB display shows them, with their dE2000.",
    .figures = skin_figures,
};

} // namespace converter
