// Within one tetrahedron of a look: of the inputs that come nearest to an output, the one nearest
// to an input.
#pragma once

#include "lutlib/rgb.h"

#include <array>

namespace lutlib {

struct TetrahedronPoint {
    RgbD input, output;
};

/// The corners' inputs must span a volume; their outputs need not. Nearness of outputs, in units of
/// `span`, goes before that of inputs, in their own units: a step of 1e-8 of the one weighs as much
/// as one of 1 of the other. Solved exactly on each corner, edge, face and on the inside.
TetrahedronPoint nearest_in_tetrahedron(const std::array<RgbD, 4>& inputs,
                                        const std::array<RgbD, 4>& outputs, RgbD input, RgbD output,
                                        double span);

} // namespace lutlib
