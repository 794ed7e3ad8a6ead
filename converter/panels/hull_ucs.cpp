#include "converter/panels/all.h"
#include "converter/panels/hull.h"
#include "converter/panels/parts.h"
#include "lutlib/color/ucs.h"

namespace converter {
namespace {

// As a share of white's; nearer to black chromaticities are noise.
constexpr double darkest = 1e-3;

double ucs_weight(lutlib::RgbD xyz) {
    return xyz.r + 15 * xyz.g + 3 * xyz.b;
}

PlanePoint place_in_ucs(lutlib::RgbD light) {
    const lutlib::RgbD xyz = xyz_of_light(light);
    const bool is_seen = xyz.r >= 0 && xyz.g >= 0 && xyz.b >= 0 &&
                         ucs_weight(xyz) > darkest * ucs_weight(xyz_of(lutlib::white_d65));
    if (!is_seen) {
        return {no_value, no_value};
    }
    const lutlib::UcsPlace place = lutlib::ucs_of(xyz);
    return {place.u, place.v};
}

std::vector<PlanePoint> triangle_of(const lutlib::Primaries& primaries) {
    std::vector<PlanePoint> out;
    for (const lutlib::Chromaticity& corner : {primaries.red, primaries.green, primaries.blue}) {
        const lutlib::UcsPlace place = lutlib::ucs_of(corner);
        out.emplace_back(place.u, place.v);
    }
    return convex_hull(out);
}

std::vector<plot::Figure> ucs_figures(ShownLooks looks) {
    const std::vector<PlanePoint> rec709 = triangle_of(lutlib::rec709);
    plot::Figure out = hull_figure(looks, place_in_ucs, rec709, "BT.709");
    out.title = "Gamut hull in CIE 1976 u'v'";
    out.x.label = "u'";
    out.y.label = "v'";
    plot::Line narrow = thin_line("BT.709"), wide = thin_line("BT.2020");
    narrow.dashed = wide.dashed = true;
    narrow.color = 7;
    wide.color = 4;
    out.lines.insert(out.lines.begin(), closed(wide, triangle_of(lutlib::rec2020)));
    out.lines.insert(out.lines.begin(), closed(narrow, rec709));
    return {out};
}

} // namespace

const Panel panel::hull_ucs{
    .name = "hull-uv",
    .label = "Gamut hull in u'v'",
    .help = "The smallest convex outline around the CIE 1976 u'v' chromaticities of all colours "
            "of the domain (25 nodes a side), before and after, with its area. Left out is what "
            "no eye sees, with a negative X, Y or Z, and what is darker than a thousandth of "
            "white.",
    .figures = ucs_figures,
};

} // namespace converter
