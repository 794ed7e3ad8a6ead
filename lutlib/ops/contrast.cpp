#include "lutlib/ops/all.h"

namespace lutlib::op {
namespace {

constexpr Parameter parameters[] = {
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
     .fallback = 0.435},
};

// x amount + pivot (1 - amount) rather than (x - pivot) amount + pivot: exact at amount 1.
Transform compile(const Values& values, const OpContext&) {
    const double amount = std::get<double>(values[0]);
    const double shift = std::get<double>(values[1]) * (1 - amount);
    return Transform::each([amount, shift](RgbD c) {
        return c * amount + RgbD{shift, shift, shift};
    });
}

} // namespace

const Op contrast{.name = "contrast",
                  .label = "Contrast",
                  .help = "Scales code values about the pivot, which stays",
                  .reference = "(x - pivot) amount + pivot",
                  .space = Space::codes,
                  .parameters = parameters,
                  .monotone_on_neutrals = true,
                  .per_channel = always,
                  .compile = compile};

} // namespace lutlib::op
