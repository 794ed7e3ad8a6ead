#include "lutlib/ops/all.h"

namespace lutlib::op {
namespace {

constexpr Parameter row(std::string_view name, std::string_view flag, std::string_view label,
                        RgbD identity) {
    return {.name = name,
            .flag = flag,
            .label = label,
            .unit = "share of red, green, blue",
            .kind = ParameterKind::rgb,
            .min = -2,
            .max = 2,
            .fallback_rgb = identity};
}

constexpr Parameter channel_mixer_parameters[] = {
    row("red", "mix-red", "Red from", {1, 0, 0}),
    row("green", "mix-green", "Green from", {0, 1, 0}),
    row("blue", "mix-blue", "Blue from", {0, 0, 1}),
};

Transform compile_channel_mixer(const Values& values, const OpContext&) {
    const auto r = std::get<RgbD>(values[0]), g = std::get<RgbD>(values[1]),
               b = std::get<RgbD>(values[2]);
    const Matrix3 m{{{{r.r, r.g, r.b}, {g.r, g.g, g.b}, {b.r, b.g, b.b}}}};
    return Transform::each([m](RgbD c) { return m * c; });
}

bool is_channel_mixer_per_channel(const Values& values) {
    const auto r = std::get<RgbD>(values[0]), g = std::get<RgbD>(values[1]),
               b = std::get<RgbD>(values[2]);
    return r.g == 0 && r.b == 0 && g.r == 0 && g.b == 0 && b.r == 0 && b.g == 0;
}

} // namespace

const Op channel_mixer{.name = "channel-mixer",
                       .label = "Channel mixer",
                       .help = "Makes each channel of linear light a sum of the three",
                       .reference = "out = M in, rows as given",
                       .space = Space::linear,
                       .parameters = channel_mixer_parameters,
                       .per_channel = is_channel_mixer_per_channel,
                       .compile = compile_channel_mixer};

} // namespace lutlib::op
