#include "lutlib/ops/all.h"
#include "lutlib/ops/luma.h"

namespace lutlib::op {
namespace {

constexpr Parameter saturation_parameters[] = {
    {.name = "amount",
     .flag = "saturation",
     .label = "Saturation",
     .unit = "factor",
     .min = 0,
     .max = 4,
     .fallback = 1},
};

Transform compile_saturation(const Values& values, const OpContext&) {
    const double amount = std::get<double>(values[0]);
    return Transform::each([amount](RgbD c) { return scale_saturation(c, amount); });
}

} // namespace

const Op saturation{.name = "saturation",
                    .label = "Saturation",
                    .help = "Moves code values away from their Rec.709 luma, or towards it",
                    .reference = "ASC CDL 1.2: luma + amount (x - luma)",
                    .space = Space::codes,
                    .parameters = saturation_parameters,
                    .monotone_on_neutrals = true,
                    .compile = compile_saturation};

} // namespace lutlib::op
