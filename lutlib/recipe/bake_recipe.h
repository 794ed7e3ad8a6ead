// A recipe becomes a LUT, fast enough to follow a slider.
#pragma once

#include "lutlib/recipe/recipe.h"

namespace lutlib {

/// Samples the exact recipe at every node, in parallel. The recipe's BakeSettings say how:
///   none         a cube over the domain
///   base         the base's own 1D table, untouched, and a cube after it: nothing is resampled
///                when the size is the base's
///   tone         a 1D table that spreads nodes evenly over what neutrals become: the mean of the
///                look's rising neutral response and a straight line, so that no part is starved
///   an encoding  a 1D table that encodes the domain's linear light, for linear input
/// The table comes first, then a cube over 0..1. Throws Error for settings that cannot be: a
/// shaper named base without a base, an encoding that does not rise over the whole domain.
///
/// A recipe whose channels do not mix, on a 1D table or on nothing, is a 1D table of as many
/// entries as curve_tolerance takes, unless the settings name a shaper or a size, which is of
/// cubes.
Lut bake_recipe(const Recipe& recipe);

/// Whether a channel of the result may depend on others of the input: by the base, an operator with
/// its values, or two encodings of different primaries.
bool mixes_channels(const Recipe& recipe);

} // namespace lutlib
