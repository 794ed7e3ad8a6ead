// What a paint program did to a strip besides grading it, in words.
#pragma once

#include "lutlib/paint/strip.h"

#include <string>
#include <vector>

namespace lutlib {

struct Harm {
    std::string name;   ///< a word for scripts: "scaled", "cropped", ...
    std::string words;  ///< a sentence with its figure and the remedy
    bool spoils = true; ///< the colours found are not the look's; else they are near it
};

struct Wholeness {
    std::vector<Harm> harms;
    /// Standard deviation of what no smooth look makes, in codes of 8 bits; rounding alone to 8
    /// bits makes 0.29. Of the strip, and of the border, which was one grey; nothing where it has
    /// none.
    double noise = 0;
    std::optional<double> border_noise;

    bool is_spoilt() const;
};

/// `alpha`: of the upright picture, a value a pixel; empty where it has none. `lossy`: what its
/// file type does to codes, a sentence without its full stop; empty where it keeps them.
Wholeness wholeness_of(const Picture& upright, const FoundStrip& strip,
                       const std::vector<float>& alpha, const std::string& lossy);

/// How much a lattice jumps beyond what is smooth along its axes: the standard deviation of noise
/// that would give its third differences, by their median over all axes and channels.
double noise_of(const Lut3D& cube);

/// In words what the whole look is but a conversion that editors make (of sRGB to another gamut or
/// curve, or back), or none at all; empty where it is neither. A lattice agrees where its mean
/// difference is below `slack`, in 0..1.
std::optional<Harm> conversion_in(const Lut3D& cube, double slack);

} // namespace lutlib
