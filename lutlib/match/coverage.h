// Which part of the colour cube the pictures of a match show, and where its look is extrapolated.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lutlib {

/// The eighth of the cube around a corner.
struct CornerCoverage {
    std::string_view name;
    double supported = 0; ///< share of its nodes
};

struct Coverage {
    int size = 0;
    double supported = 0; ///< share of the nodes about which a pixel says something
    double near = 0;      ///< share of the nodes that stand within two nodes of such a one
    /// Nodes to the nearest supported one, along any axis or diagonal; 0: it is one. The largest
    /// int where there is none.
    std::vector<int> steps;
    /// The darkest and the brightest supported grey, 0..1.
    std::optional<std::array<double, 2>> greys;
    std::array<CornerCoverage, 8> corners; ///< from black to white
};

/// `support`: of each node of a lattice of so many a side, red fastest, about how many pixels say
/// something of it (match_look.h).
Coverage coverage_of(std::span<const double> support, int size);

} // namespace lutlib
