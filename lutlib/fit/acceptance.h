// Whether a fitted lattice is better than its point samples, over colours that the fit has not
// seen.
#pragma once

#include "lutlib/interpolation/lattice_reader.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// Nodes, red fastest, with the errors of reading them: per colour the largest channel difference,
/// over colours that the fit has not seen.
struct FittedLattice {
    std::vector<RgbD> nodes;
    bool fitted = false; ///< false: the point samples were kept, as no fit was better
    ErrorStats point_sampled;
    ErrorStats result;
};

/// Colours with what the look makes of them, and the nodes from which a reader makes its answer.
class ValidationSet {
  public:
    ValidationSet(const Transform& look, const LatticeReader& reader, const SampleCounts& counts);

    const NodeWeights& weights(std::size_t colour) const { return weights_[colour]; }
    const std::vector<RgbD>& targets() const { return targets_; }

    /// Of every colour, the largest channel's; `held`: of values held to 0..1.
    std::vector<double> errors(const std::vector<RgbD>& nodes, bool held) const;

  private:
    std::vector<NodeWeights> weights_;
    std::vector<RgbD> targets_;
};

class Acceptance {
  public:
    Acceptance(const Transform& look, const LatticeReader& reader);

    /// The candidate, repaired until the validation set finds it no worse at its worst than
    /// `plain`; and that, when the candidate is then no better on average.
    FittedLattice accepted(std::vector<RgbD> candidate, const std::vector<RgbD>& plain,
                           bool held) const;

    /// Whether the look leaves 0..1 nowhere in the validation set.
    bool within_unit() const;

  private:
    void repair(std::vector<RgbD>& nodes, const std::vector<RgbD>& plain, bool held,
                double cap) const;

    // One set to find where a fit does harm, another to judge it by.
    ValidationSet repair_set_, validation_set_;
};

/// Whether no channel of any colour lies outside 0..1.
bool within_unit(const std::vector<RgbD>& colours);

} // namespace lutlib
