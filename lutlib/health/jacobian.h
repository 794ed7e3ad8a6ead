// The Jacobian of a look within one tetrahedron, and its singular values.
#pragma once

#include "lutlib/rgb.h"

#include <array>

namespace lutlib {

/// Columns: the change of the output along red, green and blue.
using Jacobian = std::array<RgbD, 3>;

double determinant(const Jacobian& j);

struct SingularValues {
    double largest = 0;
    double smallest = 0;
};

/// From the closed-form eigenvalues of J'J (O. K. Smith, "Eigenvalues of a symmetric 3 x 3 matrix",
/// CACM 4(4), 1961); the smallest from the determinant, which keeps its digits when the matrix is
/// nearly flat. Any finite entries.
SingularValues singular_values(const Jacobian& j);

} // namespace lutlib
