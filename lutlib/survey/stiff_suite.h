// Stiff and extreme looks, generated: what every verb and every interpolation must stand, and what
// errors are plotted against.
#pragma once

#include "lutlib/lut.h"

#include <span>
#include <string_view>

namespace lutlib {

struct StiffLook {
    std::string_view name;
    std::string_view help;
    /// The steepest edge between neighbouring nodes: change of an output channel per width of the
    /// input domain. 1 is the identity's over 0..1; a step in a lattice of n nodes has n - 1.
    double stiffness;
    Lut (*make)();
};

/// Every generated look, each valid (see validate()), the same on every machine.
std::span<const StiffLook> stiff_suite();
const StiffLook* stiff_look_named(std::string_view name);

} // namespace lutlib
