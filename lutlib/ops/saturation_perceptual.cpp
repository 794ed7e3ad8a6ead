#include "lutlib/ops/all.h"

namespace lutlib::op {
namespace {

constexpr Parameter saturation_perceptual_parameters[] = {
    {.name = "amount",
     .flag = "saturation-perceptual",
     .label = "Saturation, perceptual",
     .unit = "factor",
     .min = 0,
     .max = 4,
     .fallback = 1},
};

Transform compile_saturation_perceptual(const Values& values, const OpContext&) {
    const double amount = std::get<double>(values[0]);
    return Transform::each([amount](RgbD c) { return RgbD{c.r, c.g * amount, c.b * amount}; });
}

} // namespace

const Op saturation_perceptual{.name = "saturation-perceptual",
                               .label = "Saturation, perceptual",
                               .help = "Scales Oklab chroma; hue and lightness stay",
                               .reference = "Ottosson 2020: (L, amount a, amount b)",
                               .space = Space::oklab,
                               .parameters = saturation_perceptual_parameters,
                               .monotone_on_neutrals = true,
                               .compile = compile_saturation_perceptual};

} // namespace lutlib::op
