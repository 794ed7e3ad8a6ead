// How a program reads a lattice, as fitting and surveys need to know it.
#pragma once

#include "lutlib/interpolation/interpolation.h"

#include <functional>

namespace lutlib {

/// Where an input lies between a lattice's nodes, and how those are weighed.
struct LatticeReader {
    int size = 0;
    Interpolation how = Interpolation::tetrahedral;
    Domain domain; ///< the inputs that are read
    /// Place of a channel's input in units of nodes, 0 .. size-1. Must not fall.
    std::function<double(double in, std::size_t channel)> place;

    /// The nodes from which it makes its answer to an input of its domain.
    NodeWeights weights(RgbD in) const {
        return node_weights(how, size, {place(in.r, 0), place(in.g, 1), place(in.b, 2)});
    }
    /// The input whose place is `wanted`, within the domain.
    double input_at(std::size_t channel, double wanted) const;
};

/// Of a look's cube behind its shaper, if it has one.
LatticeReader reader_of(const Lut& lut, Interpolation how);

} // namespace lutlib
