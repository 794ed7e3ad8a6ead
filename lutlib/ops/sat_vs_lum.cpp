#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter sat_vs_lum_parameters[] = {
    curve_parameter("sat-vs-lum", "Luminance gain", "factor", 0, 2, 1, saturation_axis),
};

Transform compile_sat_vs_lum(const Values& values, const OpContext&) {
    const Curve curve = curve_of(sat_vs_lum_parameters[0], values[0]);
    return Transform::each([curve](RgbD c) { return c * curve(saturation_of(c)); });
}

} // namespace

const Op sat_vs_lum{.name = "sat-vs-lum",
                    .label = "Saturation vs luminance",
                    .help = "Scales luminance by a factor that depends on the saturation",
                    .reference = "factor on Oklab L, a and b",
                    .space = Space::oklab,
                    .parameters = sat_vs_lum_parameters,
                    .compile = compile_sat_vs_lum};

} // namespace lutlib::op
