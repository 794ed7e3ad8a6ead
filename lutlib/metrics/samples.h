// The colours on which a look and its bake are compared, the same for every command.
#pragma once

#include "lutlib/lut.h"

#include <cstddef>
#include <vector>

namespace lutlib {

struct SampleCounts {
    int neutral = 1024;  ///< evenly on the neutral axis, both ends included
    int random = 100000; ///< a low-discrepancy sequence over the cube
    bool lattice = true; ///< every node and every cell centre of the lattice
    int skipped = 0;     ///< how far into the sequence it starts; for colours not seen before
};

/// Colours in 0..1: the eight corners (0 and 1 exactly), the neutral axis, the lattice of size
/// `lattice_size` and its cell centres, and points of the R3 sequence (Roberts 2018),
/// which covers the cube evenly and is the same on every machine.
std::vector<Rgb> sample_colors(int lattice_size, const SampleCounts& counts);

/// Colours of 0..1 moved to where they lie in a domain.
std::vector<Rgb> over_domain(std::vector<Rgb> colors, const Domain& domain);

} // namespace lutlib
