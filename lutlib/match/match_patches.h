// A look learnt from the few colours of a chart.
#pragma once

#include "lutlib/match/match_look.h"

#include <span>
#include <vector>

namespace lutlib {

/// The base look of the patches, and a stiff lattice for what it leaves over at them.
Match match_patches(std::span<const ColorPair> patches, int size);

/// What looks that were learnt without a patch make of it, patch by patch.
std::vector<RgbD> each_from_the_others(std::span<const ColorPair> patches);

} // namespace lutlib
