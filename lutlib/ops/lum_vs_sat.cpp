#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter lum_vs_sat_parameters[] = {
    curve_parameter("lum-vs-sat", "Saturation gain", "factor", 0, 4, 1, luminance_axis),
};

Transform compile_lum_vs_sat(const Values& values, const OpContext&) {
    const Curve curve = curve_of(lum_vs_sat_parameters[0], values[0]);
    return Transform::each([curve](RgbD c) { return with_chroma(c, curve(c.r)); });
}

} // namespace

const Op lum_vs_sat{.name = "lum-vs-sat",
                    .label = "Luminance vs saturation",
                    .help = "Scales saturation by a factor that depends on the luminance",
                    .reference = "factor on Oklab chroma",
                    .space = Space::oklab,
                    .parameters = lum_vs_sat_parameters,
                    .compile = compile_lum_vs_sat};

} // namespace lutlib::op
