// The errors of one combination after another against the same look, many times a second.
#pragma once

#include "lutlib/survey/lattices.h"

#include <vector>

namespace lutlib {

/// measure() (metrics/compare.h) with the look's answers known beforehand and a shorter climb: from
/// the worst twelve colours, by each metric. `errors` gets dE2000 of the evenly spread colours.
Difference row_errors(const SurveyReference& reference, const Transform& read,
                      const LatticeSamples& samples, std::vector<double>& errors);

} // namespace lutlib
