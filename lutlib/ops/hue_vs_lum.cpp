#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter hue_vs_lum_parameters[] = {
    curve_parameter("hue-vs-lum", "Luminance gain", "factor", 0, 2, 1, hue_axis),
};

Transform compile_hue_vs_lum(const Values& values, const OpContext&) {
    const Curve curve = curve_of(hue_vs_lum_parameters[0], values[0]);
    return Transform::each(
        [curve](RgbD c) { return c * (1 + (curve(dial_hue(c.g, c.b)) - 1) * hue_weight(c)); });
}

} // namespace

const Op hue_vs_lum{.name = "hue-vs-lum",
                    .label = "Hue vs luminance",
                    .help = "Scales luminance by a factor that depends on the hue; neutrals stay",
                    .reference = "factor on Oklab L, a and b, faded out towards neutral",
                    .space = Space::oklab,
                    .parameters = hue_vs_lum_parameters,
                    .compile = compile_hue_vs_lum};

} // namespace lutlib::op
