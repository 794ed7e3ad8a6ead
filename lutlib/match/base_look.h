// The plain part of a look that is learnt from pairs of colours: what it says of colours near and
// far, so that those which no pair shows follow those which do.
#pragma once

#include "lutlib/color/matrix.h"
#include "lutlib/curve.h"
#include "lutlib/match/color_bins.h"

#include <array>
#include <span>

namespace lutlib {

/// First the matrix, then chroma about luma by a gain that depends on luma, then a curve a channel.
/// Continuous with continuous derivatives.
struct BaseLook {
    Matrix3 matrix; ///< rows sum to 1: greys stay grey before the curves
    Curve gain = Curve::open({}, 1);
    /// Each rises everywhere, or falls: over -0.25 .. 1.25, beyond which it is flat.
    std::array<Curve, 3> curves{Curve::open({}), Curve::open({}), Curve::open({})};

    RgbD operator()(RgbD in) const;
};

/// The nearest to the pairs by least squares, weakly held to smooth curves and to the identity:
/// curves with second differences as in P. Eilers and B. Marx, "Flexible Smoothing with B-splines
/// and Penalties", Statistical Science 11(2), 1996, made monotone (rising.h), with matrix and gain
/// by steps of Gauss and Newton. What goes beyond a pair that was clipped costs nothing. Throws
/// Error where no pair has a weight.
BaseLook fitted_base(std::span<const ColorPair> pairs);

} // namespace lutlib
