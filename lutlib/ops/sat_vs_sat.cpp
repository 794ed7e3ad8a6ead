#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter sat_vs_sat_parameters[] = {
    curve_parameter("sat-vs-sat", "Saturation gain", "factor", 0, 4, 1, saturation_axis),
};

Transform compile_sat_vs_sat(const Values& values, const OpContext&) {
    const Curve curve = curve_of(sat_vs_sat_parameters[0], values[0]);
    return Transform::each([curve](RgbD c) { return with_chroma(c, curve(saturation_of(c))); });
}

} // namespace

const Op sat_vs_sat{.name = "sat-vs-sat",
                    .label = "Saturation vs saturation",
                    .help = "Scales saturation by a factor that depends on the saturation",
                    .reference = "factor on Oklab chroma",
                    .space = Space::oklab,
                    .parameters = sat_vs_sat_parameters,
                    .compile = compile_sat_vs_sat};

} // namespace lutlib::op
