// Fitted lattices: nodes chosen so that what a program reads between them is nearest to the look,
// rather than nodes that are right only where they stand.
//
// Least squares over dense samples of the look, by the weights of the interpolation that will read
// the lattice:
//
//   minimise over v  sum_s w_s q_s |sum_k W_sk v_k - look(x_s)|^2 + lambda sum_k D_k |v_k - p_k|^2
//
// where p are the point samples, w_s is the share of the domain that sample s stands for, q_s of
// each channel what the eye sees of its error around look(x_s) (eye_form.h) beside an even share,
// and D_k = sum_s w_s q_s W_sk^2 makes the regularisation lambda a pure number. The eight corners
// keep their point samples, so black stays black and white white. Other nodes may leave the look's
// range beside a kink; codes hold them to 0..1.
//
// Rounding to codes then descends, node by node and code by code, on the mean error itself, as the
// eye sees it and in codes: a node that had to go up lets its neighbours go down.
#pragma once

#include "lutlib/codes.h"
#include "lutlib/fit/acceptance.h"
#include "lutlib/fit/samples.h"

#include <memory>
#include <vector>

namespace lutlib {

class LatticeFit {
  public:
    /// Samples the look and solves. `point_samples` are the look where its reader reads the nodes.
    LatticeFit(const Transform& look, const LatticeReader& reader, std::vector<RgbD> point_samples,
               const FitView& view = {});
    ~LatticeFit();
    LatticeFit(LatticeFit&&) noexcept;

    /// Nodes in full precision.
    FittedLattice exact() const;
    /// Nodes whose values are codes of that depth. Values are held to 0..1.
    /// `tightness` as of Acceptance::accepted().
    FittedLattice rounded(CodeDepth depth, double tightness = 1) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lutlib
