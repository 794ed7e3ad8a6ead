#include "converter/panels/all.h"
#include "converter/panels/parts.h"
#include "converter/panels/sweeps.h"
#include "lutlib/color/ucs.h"

namespace converter {
namespace {

// Below a ten-thousandth of white rounding is as large as the colour.
constexpr double least_luminance = 1e-4;

double saturation_of(lutlib::RgbD light, lutlib::RgbD) {
    const lutlib::RgbD xyz = xyz_of_light(light);
    return xyz.g > least_luminance && xyz.r + 15 * xyz.g + 3 * xyz.b > 0
               ? ucs_saturation(lutlib::ucs_of(xyz), lutlib::ucs_of(lutlib::white_d65))
               : no_value;
}

std::vector<plot::Figure> saturation_figures(ShownLooks looks) {
    plot::Figure out = sweep_figure(looks, saturation_of);
    out.title = "Saturation against luminance";
    out.y.label = "saturation, CIE 1976 s_uv";
    out.y.range.add(0);
    return {out};
}

} // namespace

const Panel panel::saturation{
    .name = "saturation",
    .label = "Saturation against luminance",
    .help = "The saturation of the same colours, CIE 1976 s_uv: 13 times the distance from white "
            "in u'v', which luminance alone does not change. What is darker than a "
            "ten-thousandth of white has none.",
    .figures = saturation_figures,
};

} // namespace converter
