#include "lutlib/ops/secondary.h"

namespace lutlib::op {
namespace {

constexpr Parameter hue_vs_hue_parameters[] = {
    curve_parameter("hue-vs-hue", "Hue shift", "degrees", -180, 180, 0, hue_axis),
};

Transform compile_hue_vs_hue(const Values& values, const OpContext&) {
    const Curve curve = curve_of(hue_vs_hue_parameters[0], values[0]);
    return Transform::each([curve](RgbD c) { return rotated(c, curve(dial_hue(c.g, c.b))); });
}

} // namespace

const Op hue_vs_hue{.name = "hue-vs-hue",
                    .label = "Hue vs hue",
                    .help = "Turns hues by an angle that depends on the hue",
                    .reference = "rotation of Oklab (a, b)",
                    .space = Space::oklab,
                    .parameters = hue_vs_hue_parameters,
                    .compile = compile_hue_vs_hue};

} // namespace lutlib::op
