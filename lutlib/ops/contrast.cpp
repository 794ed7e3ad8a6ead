#include "lutlib/ops/all.h"

namespace lutlib::op {
namespace {

constexpr Parameter contrast_parameters[] = {
    {.name = "amount",
     .flag = "contrast",
     .label = "Contrast",
     .unit = "slope",
     .min = 0,
     .max = 4,
     .fallback = 1},
    {.name = "pivot",
     .flag = "contrast-pivot",
     .label = "Pivot",
     .unit = "code value",
     .min = 0,
     .max = 1,
     .automatic = &OpContext::middle_grey,
     .automatic_words = "the encoding's code of 18 % grey"},
};

// x amount + pivot (1 - amount) rather than (x - pivot) amount + pivot: exact at amount 1.
Transform compile_contrast(const Values& values, const OpContext& context) {
    const double amount = std::get<double>(values[0]);
    const double shift = number_of(contrast_parameters[1], values[1], context) * (1 - amount);
    return Transform::each([amount, shift](RgbD c) {
        return c * amount + RgbD{shift, shift, shift};
    });
}

} // namespace

const Op contrast{
    .name = "contrast",
    .label = "Contrast",
    .help =
        "Scales code values about the pivot, which stays: middle grey, unless you choose another",
    .reference = "(x - pivot) amount + pivot",
    .space = Space::codes,
    .parameters = contrast_parameters,
    .monotone_on_neutrals = true,
    .per_channel = always,
    .compile = compile_contrast};

} // namespace lutlib::op
