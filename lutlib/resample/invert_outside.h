// Where the cells of an inverse leave what a look can give: nodes there have no input of their own,
// and yet what lies between them and the next nodes has.
#pragma once

#include "lutlib/lut.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lutlib {

/// What an inverse should give at one of its inputs.
struct InverseSample {
    RgbD place;  ///< in units of the inverse's nodes
    RgbD wanted; ///< the look's input
};

/// Moves the nodes that are `open` (one flag a node of the inverse's cube) so that the cube, read
/// tetrahedrally, comes nearest to the samples, by least squares (M. R. Hestenes and E. Stiefel,
/// "Methods of conjugate gradients for solving linear systems", 1952, on the normal equations), and
/// each open node the less from where it is the less the samples say of it. Returns how many moved:
/// nodes in no cell that a sample reaches stay.
std::size_t fit_open_nodes(Lut3D& cube, const std::vector<bool>& open,
                           std::span<const InverseSample> samples);

} // namespace lutlib
