// The counts along curve axes (preview/finish/curve_counts.h) in double, from lutlib's own
// operators.
#pragma once

#include "preview/finish/curve_counts.h"

#include <cstdint>
#include <span>
#include <vector>

namespace preview::reference {

/// Of display-encoded colours.
std::vector<std::uint32_t> axis_counts(std::span<const lutlib::RgbD> colors,
                                       const lutlib::Encoding& encoding);

} // namespace preview::reference
