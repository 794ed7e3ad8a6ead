// What a base look leaves over, as a lattice: smooth between the colours that are there, and
// fading away from them.
#pragma once

#include "lutlib/match/color_bins.h"

#include <span>
#include <vector>

namespace lutlib {

/// A correction for each node, and how much says so.
struct ResidualLattice {
    std::vector<RgbD> nodes; ///< size^3, red fastest (lut.h)
    /// The pairs' weights as far as they stand at the node, by the squares of its shares in them.
    std::vector<double> support;
};

struct ResidualSettings {
    RgbD smoothness{0.1, 0.1, 0.1}; ///< of each channel
    /// Second differences from which on a bend is taken for a kink of the look, of a smoothness of
    /// 1; as it grows it costs no more than its logarithm. 0: there are none, squares it is.
    double kink = 0;
    double precision = 2e-4;
    /// size^3 corrections to begin at, in place of coarser lattices; empty: none.
    std::span<const RgbD> start{};
};

/// Minimises over v, for every channel,
///
///   sum_p w_p (sum_k W_pk v_k - after_p)^2 + s sum (second differences along the axes)^2
///     + s / 10000 sum_k v_k^2
///
/// where W are the shares of nodes in the tetrahedral interpolation at before_p, in 0..1, and
/// after_p the correction that is wanted there; where that was clipped, at least or at most it, so
/// that what goes beyond it costs nothing. `smoothness` s is said for 33 nodes, and of other sizes
/// bends as much over the same way. With a `kink` q, q^2 log(1 + s d^2 / q^2) takes the place of
/// s d^2, the square of a second difference d (M. Black and A. Rangarajan, "On the unification of
/// line processes, outlier rejection, and robust statistics", IJCV 19(1), 1996), after some rounds
/// of squares by weights. From coarse lattices to fine ones by conjugate gradients, each of which
/// starts where the coarser one ended, and ends where its residual is so small a share of the right
/// side, `precision`.
ResidualLattice residual_lattice(std::span<const ColorPair> pairs, int size,
                                 const ResidualSettings& settings);

} // namespace lutlib
