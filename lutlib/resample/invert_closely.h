// An inverse as fine as its round trip asks: where a look is nearly flat its inverse is steep, so a
// lattice that is fine enough for the look may be too coarse for the inverse.
#pragma once

#include "lutlib/metrics/compare.h"
#include "lutlib/resample/invert.h"

#include <string>
#include <vector>

namespace lutlib {

struct RoundTripAim {
    double p99 = 0.5; ///< dE2000, of the inputs that can be undone
    int largest = 65; ///< nodes a side
    /// Where the attempts before let expect that this many keep the aim, these too.
    int furthest = 97;
};

struct ClosestInversion {
    Inversion inversion;
    struct Attempt {
        int size = 0;
        double p99 = 0;
        std::string shaper{}; ///< before the cube: InvertOptions::shaper
    };
    std::vector<Attempt> attempts =
        {};           ///< in turn; none of a 1D table, or where nothing can be undone
    bool kept = true; ///< the inversion is within the aim
};

/// The look and then its inverse, both read tetrahedrally.
Transform round_trip(const Lut& look, const Lut& inverse);

/// invert() at options.size; where that is empty, at the look's own size; then, where the options
/// leave the shaper open, at that size behind output_shaper(), which some file formats and all
/// strips of engines lack; then, with what of both comes nearer, with twice as many cells along
/// each axis again and again: until the round trip keeps the aim, seen as `inputs` says. Where none
/// keeps it, that which comes nearest. A look whose cells overlap so much that a finer inverse
/// would take minutes has its own size.
ClosestInversion invert_closely(const Lut& look, const InvertOptions& options,
                                const Viewing& inputs, const RoundTripAim& aim = {});

} // namespace lutlib
