#include "converter/panels/all.h"
#include "converter/panels/parts.h"
#include "converter/panels/sweeps.h"
#include "lutlib/color/oklab.h"

#include <cmath>

namespace converter {
namespace {

// Of what is nearly grey a hue says nothing.
constexpr double least_chroma = 2e-3;

double hue_of(lutlib::RgbD light) {
    const lutlib::RgbD lab = lutlib::oklab_from_linear(light);
    return std::hypot(lab.g, lab.b) > least_chroma ? lutlib::dial_hue(lab.g, lab.b) : no_value;
}

// Not a turn away from what it was before.
double hue_near(lutlib::RgbD light, lutlib::RgbD before) {
    const double hue = hue_of(light), was = hue_of(before);
    const double turn = was - hue > 180 ? 360 : was - hue < -180 ? -360 : 0;
    // Red is 0 and not 360, from whichever side.
    return hue + turn - (was > 330 ? 360 : 0);
}

std::vector<plot::Figure> hue_figures(ShownLooks looks) {
    plot::Figure out = sweep_figure(looks, hue_near);
    out.title = "Hue against luminance";
    out.y.label = "hue of Oklab in degrees, red at 0";
    for (int hue = 0; hue <= 360; hue += 60) {
        out.y.ticks.push_back({static_cast<double>(hue), std::to_string(hue)});
    }
    return {out};
}

} // namespace

const Panel panel::hue{
    .name = "hue",
    .label = "Hue against luminance",
    .help = "Colours of six hues, each half way in light from grey to the input encoding's primary "
            "or secondary, from dark to light: their hue on the dial that hue curves use (Oklab, "
            "the primaries and secondaries of sRGB 60 degrees apart). What is nearly grey has "
            "none.",
    .figures = hue_figures,
};

} // namespace converter
