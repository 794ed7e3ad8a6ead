// How much of what goes into a recipe leaves the gamut that comes out of it.
#pragma once

#include "lutlib/recipe/recipe.h"

namespace lutlib {

/// Shares 0..1 of the colours of an even lattice over the input's domain.
struct GamutShare {
    double outside = 0; ///< with a channel of negative light in the output's gamut
    double above = 0;   ///< with a channel above the light of the output's code 1
};

/// Evaluates the recipe exactly, up to its output's light. Throws Error as Edit does.
GamutShare gamut_share(const Recipe& recipe, const Domain& domain);

} // namespace lutlib
