// Rounding a fitted lattice to codes, with an eye on what its readers will see.
#pragma once

#include "lutlib/codes.h"
#include "lutlib/rgb.h"

#include <vector>

namespace lutlib {

/// Colours of a look, each as the weighted sum of nodes that its reader makes; sample s has the
/// entries first[s] .. first[s+1] of `node` and `weight`.
struct FitSamples {
    std::vector<int> first, node;
    std::vector<float> weight;
    std::vector<float> share; ///< of the domain
    std::vector<RgbD> target;

    RgbD read(const std::vector<RgbD>& nodes, std::size_t s) const {
        RgbD sum;
        for (auto k = static_cast<std::size_t>(first[s]);
             k < static_cast<std::size_t>(first[s + 1]); ++k) {
            sum = sum + static_cast<double>(weight[k]) * nodes[static_cast<std::size_t>(node[k])];
        }
        return sum;
    }
};

/// Each value held to 0..1 and rounded to the nearest code.
std::vector<RgbD> rounded_to_codes(std::vector<RgbD> nodes, CodeDepth depth);

/// Moves single nodes by single codes as long as that lowers the mean error over the samples, and
/// holds the largest error below that of `plain`. Nodes that are fixed become `plain`'s. The
/// result does not depend on the number of threads.
std::vector<RgbD> descended(const FitSamples& samples, std::vector<RgbD> nodes,
                            const std::vector<RgbD>& plain, const std::vector<bool>& fixed,
                            int size, CodeDepth depth);

} // namespace lutlib
