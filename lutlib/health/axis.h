// How one input channel runs through the cells of a look's cube, with or without a shaper before
// it.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <vector>

namespace lutlib {

/// One cell of one axis.
struct AxisCell {
    bool reached = false;
    double slope = 0; ///< steepest: widths of the cube's domain per width of the input's
    double input = 0; ///< where it is steepest, as an input of the look
    double width = 0; ///< share of the input's domain that runs through the cell in the main sense
};

using AxisCells = std::vector<AxisCell>;

/// Of each channel, for a cube of `size` nodes per axis. Without a shaper every cell is reached
/// with a slope of 1.
std::array<AxisCells, 3> cells_of_axes(const Lut& lut, int size, const Domain& cube_domain);

/// Of each channel and node, the lowest input of the look that reaches the node of its cube; where
/// the shaper reaches none, that of the nearest entry.
std::array<std::vector<double>, 3> inputs_of_nodes(const Lut& lut, const Lut3D& cube);

} // namespace lutlib
