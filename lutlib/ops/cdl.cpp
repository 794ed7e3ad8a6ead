// The ASC Color Decision List, version 1.2: (x slope + offset)^power, then saturation.
#include "lutlib/color/powers.h"
#include "lutlib/ops/all.h"
#include "lutlib/ops/luma.h"

namespace lutlib::op {
namespace {

constexpr Parameter rgb(std::string_view name, std::string_view flag, std::string_view label,
                        double min, double max, double neutral, const Wheel& wheel) {
    return {.name = name,
            .flag = flag,
            .label = label,
            .kind = ParameterKind::rgb,
            .min = min,
            .max = max,
            .fallback_rgb = {neutral, neutral, neutral},
            .wheel = wheel};
}

constexpr Parameter cdl_parameters[] = {
    rgb("slope", "cdl-slope", "Slope", 0, 10, 1, {.balance = 0.4, .brightness = 1}),
    rgb("offset", "cdl-offset", "Offset", -10, 10, 0, {.balance = 0.15, .brightness = 0.3}),
    rgb("power", "cdl-power", "Power", 0.05, 10, 1,
        {.balance = 0.3, .brightness = 0.8, .is_inverted = true}),
    {.name = "saturation",
     .flag = "cdl-saturation",
     .label = "Saturation",
     .min = 0,
     .max = 10,
     .fallback = 1},
    {.name = "clamp",
     .flag = "cdl-clamp",
     .label = "Clamp to 0..1 as the standard does",
     .kind = ParameterKind::toggle,
     .fallback = 0},
};

Transform compile_cdl(const Values& values, const OpContext&) {
    const auto slope = std::get<RgbD>(values[0]), offset = std::get<RgbD>(values[1]),
               power = std::get<RgbD>(values[2]);
    const double saturation = std::get<double>(values[3]);
    const bool clamp = std::get<double>(values[4]) != 0;
    const auto clamped = [clamp](RgbD c) { return clamp ? lutlib::saturate(c) : c; };
    return Transform::batch([=](std::span<RgbD> colors) {
        for (RgbD& c : colors) {
            for (std::size_t i = 0; i < 3; ++i) {
                c[i] = c[i] * slope[i] + offset[i];
            }
            c = clamped(c);
        }
        power_all(colors, power, Negative::kept);
        for (RgbD& c : colors) {
            c = clamped(scale_saturation(c, saturation));
        }
    });
}

bool is_cdl_per_channel(const Values& values) {
    return std::get<double>(values[3]) == 1;
}

} // namespace

const Op cdl{.name = "cdl",
             .label = "ASC CDL",
             .help = "Slope, offset, power and saturation of a Color Decision List. Without clamp, "
                     "values below zero take no power and nothing is cut",
             .reference = "ASC CDL 1.2; without clamp as OpenColorIO's CDL_NO_CLAMP",
             .space = Space::codes,
             .parameters = cdl_parameters,
             .monotone_on_neutrals = false,
             .per_channel = is_cdl_per_channel,
             .compile = compile_cdl};

} // namespace lutlib::op
