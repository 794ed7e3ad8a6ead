#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter hue_vs_sat_parameters[] = {
    curve_parameter("hue-vs-sat", "Saturation gain", "factor", 0, 4, 1, hue_axis),
};

Transform compile_hue_vs_sat(const Values& values, const OpContext&) {
    const Curve curve = curve_of(hue_vs_sat_parameters[0], values[0]);
    return Transform::each([curve](RgbD c) { return with_chroma(c, curve(dial_hue(c.g, c.b))); });
}

} // namespace

const Op hue_vs_sat{.name = "hue-vs-sat",
                    .label = "Hue vs saturation",
                    .help = "Scales saturation by a factor that depends on the hue",
                    .reference = "factor on Oklab chroma",
                    .space = Space::oklab,
                    .parameters = hue_vs_sat_parameters,
                    .compile = compile_hue_vs_sat};

} // namespace lutlib::op
