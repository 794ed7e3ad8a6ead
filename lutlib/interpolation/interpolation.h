// Evaluation of one colour: the float path that everything else is held to, and its double oracle.
//
// Outside the domain every channel is clamped: -Inf reads as the minimum, +Inf as the maximum,
// and NaN as the minimum. A finite LUT therefore has a finite answer for every input.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace lutlib {

struct InterpolationInfo {
    Interpolation kind;
    std::string_view name;
    std::string_view help;
};

/// Every interpolation, in order of quality.
std::span<const InterpolationInfo> interpolations();
std::optional<Interpolation> interpolation_named(std::string_view name);
std::string_view name_of(Interpolation kind);

/// What a look's cube is read by where nobody says: what the look asks for, else tetrahedral.
Interpolation usual_interpolation(const Lut& lut);

/// The tetrahedra of a cell: the orders in which a path from its dark corner to its bright one
/// walks along the axes.
using Walk = std::array<std::size_t, 3>;
inline constexpr std::array<Walk, 6> tetrahedron_walks{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// The walk along the axes in order of falling fraction, equal ones in their own order: that of the
/// tetrahedron which holds the place.
template <class T>
constexpr const Walk& axes_by_fraction(const std::array<T, 3>& fraction) {
    const auto [r, g, b] = fraction;
    if (r >= g) {
        return tetrahedron_walks[g >= b ? 0 : r >= b ? 1 : 4];
    }
    return tetrahedron_walks[r >= b ? 2 : g >= b ? 3 : 5];
}

/// A curve is always interpolated linearly; `Interpolation` chooses how the cube is.
Rgb evaluate(const Lut1D& curve, Rgb in);
Rgb evaluate(const Lut3D& cube, Rgb in, Interpolation how);
/// By usual_interpolation().
Rgb evaluate(const Lut& lut, Rgb in);
Rgb evaluate(const Lut& lut, Rgb in, Interpolation how);

/// What an interpolation makes of a lattice, as the nodes that it reads and their shares: a colour
/// is the sum of weight * node. Indices rise; nodes of weight 0 are left out.
struct NodeWeights {
    std::size_t count = 0;
    std::array<std::size_t, 8> node{};
    std::array<double, 8> weight{};
};
/// `place` in units of nodes, clamped to 0 .. size-1.
NodeWeights node_weights(Interpolation how, int size, RgbD place);

/// The same functions in double, written from the definitions: trilinear as the weighted sum of
/// eight corners, tetrahedral by sorting the fractions (Kanamori, "Color interpolation", 1993).
RgbD evaluate_exact(const Lut1D& curve, RgbD in);
RgbD evaluate_exact(const Lut3D& cube, RgbD in, Interpolation how);
RgbD evaluate_exact(const Lut& lut, RgbD in);
RgbD evaluate_exact(const Lut& lut, RgbD in, Interpolation how);

} // namespace lutlib
