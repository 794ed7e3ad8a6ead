// Where a map that is read between nodes may bend: two such maps differ most where one of them
// does.
#pragma once

#include "lutlib/interpolation/lattice_reader.h"

#include <array>
#include <vector>

namespace lutlib {

/// Per channel, the inputs at which a map bends or jumps, rising. `all`: between them it is as
/// smooth as its interpolation; a recipe bends anywhere, so its breaks are not all.
struct Breaks {
    std::array<std::vector<double>, 3> at;
    bool all = true;
};

/// The nodes of a look's cube, as inputs of the look; the ends of its 1D table, and the table's
/// entries: all of a table alone, else all of a short one.
Breaks breaks_of(const Lut& look, Interpolation how);
Breaks breaks_of(const Lut& look);
/// The inputs that a lattice's reader finds at its nodes.
Breaks breaks_of(const LatticeReader& reader);
/// Of a smooth map, or one of which nothing is known.
Breaks no_breaks();

/// Those of both.
Breaks united(const Breaks& a, const Breaks& b);

} // namespace lutlib
