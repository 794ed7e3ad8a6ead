#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter lum_vs_lum_parameters[] = {
    curve_parameter("lum-vs-lum", "Luminance gain", "factor", 0, 4, 1, luminance_axis),
};

Transform compile_lum_vs_lum(const Values& values, const OpContext&) {
    const Curve curve = curve_of(lum_vs_lum_parameters[0], values[0]);
    return Transform::each([curve](RgbD c) { return c * curve(c.r); });
}

} // namespace

const Op lum_vs_lum{.name = "lum-vs-lum",
                    .label = "Luminance vs luminance",
                    .help = "Scales luminance by a factor that depends on the luminance",
                    .reference = "factor on Oklab L, a and b",
                    .space = Space::oklab,
                    .parameters = lum_vs_lum_parameters,
                    .compile = compile_lum_vs_lum};

} // namespace lutlib::op
