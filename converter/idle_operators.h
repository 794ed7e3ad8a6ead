// Operators whose values leave every colour as it is, such as the hue of a split without an
// amount: found by trying, whatever the operator.
#pragma once

#include "lutlib/recipe/recipe.h"

#include <cstddef>

namespace converter {

/// Whether an operator of the recipe is on and away from its defaults, and yet changes no colour of
/// a lattice over 0..1 and of one far beyond.
bool is_idle(const lutlib::Recipe& recipe, const lutlib::Operation& operation);

/// Says which of the recipe's operators from that number on are idle.
void tell_idle_operators(const lutlib::Recipe& recipe, std::size_t first);

} // namespace converter
