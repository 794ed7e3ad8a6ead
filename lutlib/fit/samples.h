// Dense samples of a look, each as the weighted sum of nodes that a lattice's reader makes of it.
#pragma once

#include "lutlib/interpolation/lattice_reader.h"
#include "lutlib/metrics/eye_form.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// Sample s has the entries first[s] .. first[s+1] of `node` and `weight`; a sample's nodes rise.
struct FitSamples {
    std::vector<int> first, node;
    std::vector<float> weight;
    std::vector<float> share; ///< of the domain
    std::vector<RgbD> target;
    std::vector<EyeForm> form; ///< around each target

    RgbD read(const std::vector<RgbD>& nodes, std::size_t s) const {
        RgbD sum;
        for (auto k = static_cast<std::size_t>(first[s]);
             k < static_cast<std::size_t>(first[s + 1]); ++k) {
            sum = sum + static_cast<double>(weight[k]) * nodes[static_cast<std::size_t>(node[k])];
        }
        return sum;
    }
};

/// Samples on a grid several times as fine as the lattice, with each node on it.
FitSamples fit_samples(const Transform& look, const LatticeReader& reader, const Viewing& viewing);

/// The look of many colours, in parallel; NaN becomes 0.
std::vector<RgbD> mapped(const Transform& look, std::vector<RgbD> colors);

/// The look at each node, where the reader reads it, in the order of nodes.
std::vector<RgbD> point_samples(const Transform& look, const LatticeReader& reader);

} // namespace lutlib
