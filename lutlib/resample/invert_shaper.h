// The 1D table before an inverse's cube that puts the nodes where the look's outputs crowd.
#pragma once

#include "lutlib/lut.h"

#include <span>
#include <string_view>

namespace lutlib {

/// InvertOptions::shaper of output_shaper().
inline constexpr std::string_view outputs_shaper = "look";

/// Where a look is nearly flat, as towards a soft white, many inputs crowd in few outputs, and its
/// inverse is steep there. Per channel this table rises by the share of `outputs`, over inputs
/// spread evenly, that lie below (the equalisation of a histogram), and by a fifth evenly, so that
/// it rises everywhere. From 0 to 1 over `domain`; outputs at its very ends, as of clipped inputs,
/// do not count. Throws Error for a size or a domain outside limits.h.
Lut1D output_shaper(std::span<const RgbD> outputs, const Domain& domain, int size);

} // namespace lutlib
