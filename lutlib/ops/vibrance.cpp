#include "lutlib/color/oklab.h"
#include "lutlib/ops/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib::op {
namespace {

constexpr Parameter vibrance_parameters[] = {
    {.name = "amount",
     .flag = "vibrance",
     .label = "Vibrance",
     .unit = "share",
     .min = -1,
     .max = 1,
     .fallback = 0},
};

// The derivative of s (1 + amount (1 - s)^2) is positive for every |amount| <= 1, so colours keep
// their order of saturation.
Transform compile_vibrance(const Values& values, const OpContext&) {
    const double amount = std::get<double>(values[0]);
    return Transform::each([amount](RgbD c) {
        const double room = 1 - std::min(std::hypot(c.g, c.b) / srgb_chroma, 1.0);
        const double factor = 1 + amount * room * room;
        return RgbD{c.r, c.g * factor, c.b * factor};
    });
}

} // namespace

const Op vibrance{.name = "vibrance",
                  .label = "Vibrance",
                  .help = "Saturates pale colours more than vivid ones",
                  .reference = "Oklab chroma C (1 + amount (1 - s)^2), s = C / .3225, at most 1",
                  .space = Space::oklab,
                  .parameters = vibrance_parameters,
                  .monotone_on_neutrals = true,
                  .compile = compile_vibrance};

} // namespace lutlib::op
