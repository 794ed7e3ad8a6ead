// The least squares of a fit (fit.h) as its normal equations, sparse: a node has entries with
// itself and the nodes around it alone.
#pragma once

#include "lutlib/fit/samples.h"

#include <vector>

namespace lutlib {

/// The nodes that minimise the weighted squares over the samples, regularised towards `point`, the
/// nodes' point samples. Nodes that are fixed keep those.
std::vector<RgbD> least_squares(const FitSamples& samples, const std::vector<RgbD>& point,
                                const std::vector<bool>& fixed, int size);

} // namespace lutlib
