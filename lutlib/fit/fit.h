// Fitted lattices: nodes chosen so that what a program reads between them is nearest to the look,
// rather than nodes that are right only where they stand.
//
// Least squares over dense samples of the look, by the weights of the interpolation that will read
// the lattice:
//
//   minimise over v  sum_s w_s |sum_k W_sk v_k - look(x_s)|^2 + lambda sum_k D_k |v_k - p_k|^2
//
// where p are the point samples, w_s is the share of the domain that sample s stands for, and
// D_k = sum_s w_s W_sk^2 makes lambda a pure number. The eight corners keep their point samples, so
// black stays black and white white. Other nodes may leave the look's range beside a kink; codes
// hold them to 0..1.
//
// Rounding to codes then descends, node by node and code by code, on the mean error itself: a node
// that had to go up lets its neighbours go down.
#pragma once

#include "lutlib/codes.h"
#include "lutlib/engine/engine.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/transform.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace lutlib {

/// How a lattice is read: where an input lies between its nodes, and how those are weighed.
struct LatticeReader {
    int size = 0;
    Interpolation how = Interpolation::tetrahedral;
    Domain domain; ///< the inputs that are read
    /// Place of a channel's input in units of nodes, 0 .. size-1. Must not fall.
    std::function<double(double in, std::size_t channel)> place;
};

LatticeReader reader_of(const Engine& engine, int size);
/// Of a look's cube behind its shaper, if it has one.
LatticeReader reader_of(const Lut& lut, Interpolation how);

/// Nodes, red fastest, with the errors of reading them: per colour the largest channel difference,
/// over colours that the fit has not seen.
struct FittedLattice {
    std::vector<RgbD> nodes;
    bool fitted = false; ///< false: the point samples were kept, as no fit was better
    ErrorStats point_sampled;
    ErrorStats result;
};

class LatticeFit {
  public:
    /// Samples the look and solves. `point_samples` are the look where its reader reads the nodes.
    LatticeFit(const Transform& look, LatticeReader reader, std::vector<RgbD> point_samples);
    ~LatticeFit();
    LatticeFit(LatticeFit&&) noexcept;

    /// Nodes in full precision.
    FittedLattice exact() const;
    /// Nodes whose values are codes of that depth. Values are held to 0..1.
    FittedLattice rounded(CodeDepth depth) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The look at each node, where the reader reads it, in the order of nodes.
std::vector<RgbD> point_samples(const Transform& look, const LatticeReader& reader);

} // namespace lutlib
