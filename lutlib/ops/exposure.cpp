#include "lutlib/ops/all.h"

#include <cmath>

namespace lutlib::op {
namespace {

constexpr Parameter exposure_parameters[] = {
    {.name = "stops",
     .flag = "exposure",
     .label = "Exposure",
     .unit = "stops",
     .min = -10,
     .max = 10,
     .fallback = 0},
};

Transform compile_exposure(const Values& values, const OpContext&) {
    const double gain = std::exp2(std::get<double>(values[0]));
    return Transform::each([gain](RgbD c) { return c * gain; });
}

} // namespace

const Op exposure{.name = "exposure",
                  .label = "Exposure",
                  .help = "Multiplies linear light; one stop doubles it",
                  .reference = "light * 2^stops",
                  .space = Space::linear,
                  .parameters = exposure_parameters,
                  .monotone_on_neutrals = true,
                  .per_channel = always,
                  .compile = compile_exposure};

} // namespace lutlib::op
