// Whether a fitted lattice is better than its point samples, over colours that the fit has not
// seen and over those where errors peak.
#pragma once

#include "lutlib/interpolation/lattice_reader.h"
#include "lutlib/metrics/breaks.h"
#include "lutlib/metrics/eye_form.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// What a fit has to know of the look besides its colours.
struct FitView {
    Breaks breaks = no_breaks();
    Viewing viewing = {};
};

/// Nodes, red fastest, with the errors of reading them: per colour the largest channel difference,
/// over colours that the fit has not seen.
struct FittedLattice {
    std::vector<RgbD> nodes;
    bool fitted = false; ///< false: the point samples were kept, as no fit was better
    ErrorStats point_sampled;
    ErrorStats result;
};

class Acceptance {
  public:
    Acceptance(const Transform& look, const LatticeReader& reader, const FitView& view);

    /// The candidate, with nodes given back their plain values until it is nowhere worse than
    /// `plain` is at its worst, in code values and to the eye, over the union grid and between; nor
    /// greys more tinted. And `plain`, when the candidate then has no lower mean of both.
    /// `tightness`: of the largest errors, the share that it may reach.
    FittedLattice accepted(std::vector<RgbD> candidate, const std::vector<RgbD>& plain, bool held,
                           double tightness = 1) const;

    /// Whether the look leaves 0..1 nowhere.
    bool within_unit() const;

  private:
    struct Errors {
        std::vector<double> code, eye;
    };
    Errors errors(const std::vector<RgbD>& nodes, bool held) const;
    ErrorStats of_even(const std::vector<double>& errors) const;

    Eye eye_;
    Metric metric_;
    std::size_t even_ = 0, neutral_ = 0; // the first so many colours, and those after them
    std::vector<NodeWeights> weights_;
    std::vector<RgbD> targets_;
};

/// Whether no channel of any colour lies outside 0..1.
bool within_unit(const std::vector<RgbD>& colors);

} // namespace lutlib
