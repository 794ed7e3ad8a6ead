#include "converter/panels/all.h"
#include "converter/panels/hull.h"
#include "converter/panels/parts.h"
#include "lutlib/color/oklab.h"

namespace converter {
namespace {

PlanePoint place_in_oklab(lutlib::RgbD light) {
    const lutlib::RgbD lab = lutlib::oklab_from_linear(light);
    return {lab.g, lab.b};
}

std::vector<PlanePoint> srgb_hull() {
    std::vector<PlanePoint> out;
    for (const lutlib::RgbD& light : light_before({"", {}, {}, lutlib::srgb(), lutlib::srgb()})) {
        out.push_back(place_in_oklab(light));
    }
    return convex_hull(std::move(out));
}

std::vector<plot::Figure> oklab_figures(ShownLooks looks) {
    const std::vector<PlanePoint> srgb = srgb_hull();
    plot::Figure out = hull_figure(looks, place_in_oklab, srgb, "sRGB");
    out.title = "Gamut hull in Oklab";
    out.x.label = "a";
    out.y.label = "b";
    plot::Line whole = thin_line("sRGB");
    whole.dashed = true;
    whole.color = 7;
    out.lines.insert(out.lines.begin(), closed(whole, srgb));
    return {out};
}

} // namespace

const Panel panel::hull_oklab{
    .name = "hull-oklab",
    .label = "Gamut hull in Oklab",
    .help = "The smallest convex outline around a and b of Oklab of the same colours, dark ones "
            "too, with its area. It grows with luminance: light of 8 times white is twice as far "
            "from the middle.",
    .figures = oklab_figures,
};

} // namespace converter
