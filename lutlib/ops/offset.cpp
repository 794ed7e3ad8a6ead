#include "lutlib/ops/all.h"

namespace lutlib::op {
namespace {

constexpr Parameter offset_parameters[] = {
    {.name = "amount",
     .flag = "offset",
     .label = "Offset",
     .unit = "code values",
     .kind = ParameterKind::rgb,
     .min = -1,
     .max = 1,
     .wheel = {.balance = 0.15, .brightness = 0.3}},
};

Transform compile_offset(const Values& values, const OpContext&) {
    const auto amount = std::get<RgbD>(values[0]);
    return Transform::each([amount](RgbD c) { return c + amount; });
}

} // namespace

const Op offset{.name = "offset",
                .label = "Offset",
                .help = "Adds to every code value",
                .reference = "x + amount",
                .space = Space::codes,
                .parameters = offset_parameters,
                .monotone_on_neutrals = true,
                .per_channel = always,
                .compile = compile_offset};

} // namespace lutlib::op
