// The colours on which two maps are compared, the same for every verb: some that tell how large
// errors usually are, and those among which the largest hides.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/metrics/breaks.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lutlib {

struct SampleLimits {
    std::size_t even = 50'000;     ///< ErrorSamples::even
    std::size_t grid = 1 << 19;    ///< of the union grid; of a larger one, a part
    std::size_t between = 1 << 17; ///< of the middles between its colours
};

using UnionAxes = std::array<std::vector<float>, 3>;

/// How many of a grid's cells, and of its own colours, are to be looked at more closely
/// (suspects.h): by code values, and as many to the eye.
struct SuspectCount {
    std::size_t cells = 0, nodes = 0;
};

struct ErrorSamples {
    Domain domain;
    /// Spread evenly over the domain's code values (sample_colors(), each moved a little, so that
    /// no lattice is met in step): means and percentiles are of these alone.
    std::vector<Rgb> even;
    /// Where errors may peak.
    std::vector<Rgb> hiding;
    /// Of what `hiding` leaves out of the grid and its middles.
    SuspectCount suspects;
    /// Per channel, the coordinates of the union grid, rising, the domain's ends among them.
    UnionAxes axis;
    /// hiding has all of the union grid, and the grid has all breaks: a maximum over it, climbed,
    /// is the maximum; else it is the largest that was seen.
    bool whole = true;
};

/// The union grid is every colour whose channels are breaks of one of the maps or an end of the
/// domain. Two piecewise linear maps differ most on it; what is linear between diagonals, or not
/// linear to the eye, between. `hiding` is that grid; 256 neutrals and those of the grid; and the
/// middles of its cells, faces and edges: all where they are no more than `limits.between`, else
/// those of cells up to that number, those on the domain's faces up to half of it, and an eighth of
/// it of any kind, spread evenly.
///
/// Of a grid with more colours than `limits.grid`: its corners, its edges and faces up to a
/// quarter of that number each, and the rest from within, spread evenly (the R3 sequence).
///
/// What is chosen by number may miss a fault of a single node. So where not all is looked at, and
/// the grid has no more than eight times that number, `suspects` asks for the cells and colours in
/// which the maps themselves show that an error may be large.
ErrorSamples error_samples(const Domain& domain, const Breaks& breaks,
                           const SampleLimits& limits = {});

/// ErrorSamples::even alone, for shares of a domain.
std::vector<Rgb> even_samples(const Domain& domain, std::size_t count = SampleLimits{}.even);
/// ErrorSamples::axis alone.
UnionAxes union_axes(const Domain& domain, const Breaks& breaks);

} // namespace lutlib
