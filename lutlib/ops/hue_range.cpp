// Hue-selective range: one band of hues is turned, saturated and lit on its own.
//
// A hue counts fully within width / 2 of the centre and falls to nothing over the softness, along a
// raised cosine.
#include "lutlib/ops/secondary.h"

#include <algorithm>
#include <numbers>

namespace lutlib::op {
namespace {

constexpr Parameter number(std::string_view name, std::string_view flag, std::string_view label,
                           std::string_view unit, double min, double max, double fallback) {
    return {.name = name,
            .flag = flag,
            .label = label,
            .unit = unit,
            .min = min,
            .max = max,
            .fallback = fallback};
}

constexpr Parameter hue_range_parameters[] = {
    number("centre", "range-centre", "Centre", "degrees, red at 0", 0, 360, 0),
    number("width", "range-width", "Width", "degrees", 0, 360, 40),
    number("softness", "range-softness", "Softness", "degrees", 5, 180, 30),
    number("turn", "range-turn", "Turn", "degrees", -180, 180, 0),
    number("saturation", "range-saturation", "Saturation", "factor", 0, 4, 1),
    number("luminance", "range-luminance", "Luminance", "factor", 0, 2, 1),
};

Transform compile_hue_range(const Values& values, const OpContext&) {
    const auto value = [&values](std::size_t i) { return std::get<double>(values[i]); };
    const double centre = value(0), full = value(1) / 2, softness = value(2);
    const double turn = value(3), saturation = value(4), luminance = value(5);
    return Transform::each([=](RgbD c) {
        const double away = std::abs(std::remainder(dial_hue(c.g, c.b) - centre, 360.0));
        const double outside = std::clamp((away - full) / softness, 0.0, 1.0);
        const double weight = 0.5 + 0.5 * std::cos(outside * std::numbers::pi);
        const RgbD out = with_chroma(rotated(c, turn * weight), 1 + (saturation - 1) * weight);
        return out * (1 + (luminance - 1) * weight * hue_weight(c));
    });
}

} // namespace

const Op hue_range{.name = "hue-range",
                   .label = "Hue range",
                   .help = "Turns, saturates and lights one band of hues",
                   .reference = "rotation and factors in Oklab, weighted by a raised cosine of hue",
                   .space = Space::oklab,
                   .parameters = hue_range_parameters,
                   .compile = compile_hue_range};

} // namespace lutlib::op
