// The lattices that a survey looks at: point samples of every size and shaper, and fits.
#pragma once

#include "lutlib/survey/survey.h"
#include "lutlib/transform.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lutlib {

/// What is surveyed: a look, and colours with what it makes of them.
struct SurveyReference {
    const Recipe& recipe;
    Transform exact; ///< the look
    Transform shown; ///< the look as it is judged
    Domain domain;
    Viewing viewing;
    Breaks breaks;
    std::vector<Rgb> inputs; ///< evenly spread
    std::vector<RgbD> expected;
    bool clamped = false;   ///< `expected`, and what lookups give, are held to 0..1
    OutsideDisplay outside; ///< of the look's results before that

    SurveyReference(const Recipe& recipe, const SurveySettings& settings);

    /// A lookup's result as it is judged.
    RgbD seen(RgbD c) const { return clamped ? saturate(c) : c; }
    /// By dE2000, of results as they are judged; into a span of the same length.
    void delta_e(std::span<const RgbD> a, std::span<const RgbD> b, std::span<double> out) const;
    /// A lattice's answers as they are judged.
    Transform reading(std::shared_ptr<const StoredLut> stored, const Lookup& lookup) const;
};

/// Where a lattice's errors may hide, and what the look makes of `at.hiding`.
struct LatticeSamples {
    ErrorSamples at;
    std::vector<RgbD> expected;
};

/// A lattice before storage: its nodes by point sampling.
struct PointLattice {
    const ShaperChoice* shaper = nullptr;
    Lut lut;
    std::shared_ptr<const std::vector<RgbD>> nodes;
    double seconds = 0; ///< that it took
    std::shared_ptr<const LatticeSamples> samples;
};

/// The first choice.
const ShaperChoice& no_shaper();

struct PointLattices {
    std::vector<PointLattice> rows;
    std::vector<std::string> notes; ///< which shapers were left out, and why
};

/// Every size with every shaper; those that cannot be or do nothing are left out.
PointLattices point_lattices(const SurveyReference& reference, const SurveySettings& settings,
                             const Progress& progress);

/// One way of keeping the look, with its nodes.
struct Candidate {
    const PointLattice* lattice = nullptr;
    Combination what;
    std::shared_ptr<const std::vector<RgbD>> nodes;
    double seconds = 0; ///< that it took
};

/// Every lattice in every storage for every lookup, as it was sampled.
std::vector<Candidate> point_candidates(const std::vector<PointLattice>& lattices);

struct FittedCandidates {
    std::vector<Candidate> rows;
    std::vector<std::string> notes; ///< what was not fitted, and why
};

/// Fits wherever they may help: where a shaper does not make point samples worse than none does, or
/// is the look's or the recipe's own.
FittedCandidates fitted_candidates(const SurveyReference& reference,
                                   const std::vector<PointLattice>& lattices,
                                   const SurveySettings& settings, const Progress& progress);

} // namespace lutlib
