// Several lattices below each other in one picture.
#pragma once

#include "lutlib/bake/bake.h"

#include <vector>

namespace lutlib {

/// Whether the engine has a lookup that picks one of several lattices below each other.
bool reads_stacks(const Engine& engine);

/// Bakes of one engine, size and depth below each other, the first on top. The losses are those of
/// all. Throws UsageError where they differ or the engine reads no such picture.
Bake stacked(const std::vector<Bake>& bakes);

} // namespace lutlib
