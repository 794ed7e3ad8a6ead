#include "lutlib/color/powers.h"
#include "lutlib/ops/all.h"

namespace lutlib::op {
namespace {

constexpr Parameter rgb(std::string_view name, std::string_view label, double min, double max,
                        double neutral, const Wheel& wheel) {
    return {.name = name,
            .flag = name,
            .label = label,
            .unit = "code values",
            .kind = ParameterKind::rgb,
            .min = min,
            .max = max,
            .fallback_rgb = {neutral, neutral, neutral},
            .wheel = wheel};
}

constexpr Parameter lift_gamma_gain_parameters[] = {
    rgb("lift", "Lift", -0.5, 0.5, 0, {.balance = 0.15, .brightness = 0.3}),
    rgb("gamma", "Gamma", 0.1, 10, 1, {.balance = 0.3, .brightness = 0.8}),
    rgb("gain", "Gain", 0, 4, 1, {.balance = 0.4, .brightness = 1}),
};

Transform compile_lift_gamma_gain(const Values& values, const OpContext&) {
    const auto lift = std::get<RgbD>(values[0]), gamma = std::get<RgbD>(values[1]),
               gain = std::get<RgbD>(values[2]);
    const RgbD power{1 / gamma.r, 1 / gamma.g, 1 / gamma.b};
    return Transform::batch([lift, gain, power](std::span<RgbD> colors) {
        for (RgbD& c : colors) {
            for (std::size_t i = 0; i < 3; ++i) {
                c[i] = gain[i] * (c[i] + lift[i] * (1 - c[i]));
            }
        }
        power_all(colors, power, Negative::mirrored);
    });
}

} // namespace

const Op lift_gamma_gain{
    .name = "lift-gamma-gain",
    .label = "Lift, gamma, gain",
    .help = "Lift moves black and holds white, gain scales, gamma bends the middle",
    .reference = "(gain (x + lift (1 - x)))^(1 / gamma), odd below zero",
    .space = Space::codes,
    .parameters = lift_gamma_gain_parameters,
    .monotone_on_neutrals = true,
    .per_channel = always,
    .compile = compile_lift_gamma_gain};

} // namespace lutlib::op
