// Rounding a fitted lattice to codes, with an eye on what its readers will see.
#pragma once

#include "lutlib/codes.h"
#include "lutlib/fit/samples.h"

#include <vector>

namespace lutlib {

/// Each value held to 0..1 and rounded to the nearest code.
std::vector<RgbD> rounded_to_codes(std::vector<RgbD> nodes, CodeDepth depth);

/// Moves single nodes by single codes as long as that lowers the mean error over the samples, and
/// holds the largest error below that of `plain`. Nodes that are fixed become `plain`'s. The
/// result does not depend on the number of threads.
std::vector<RgbD> descended(const FitSamples& samples, std::vector<RgbD> nodes,
                            const std::vector<RgbD>& plain, const std::vector<bool>& fixed,
                            int size, CodeDepth depth);

} // namespace lutlib
