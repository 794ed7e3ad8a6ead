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
#include <utility>

namespace lutlib {

enum class Interpolation { nearest, trilinear, tetrahedral };

struct InterpolationInfo {
    Interpolation kind;
    std::string_view name;
    std::string_view help;
};

/// Every interpolation, in order of quality.
std::span<const InterpolationInfo> interpolations();
std::optional<Interpolation> interpolation_named(std::string_view name);
std::string_view name_of(Interpolation kind);

/// The axes in order of falling fraction, equal ones in their own order: the way that tetrahedral
/// interpolation walks from a cell's dark corner to its bright one.
template <class T>
constexpr std::array<std::size_t, 3> axes_by_fraction(const std::array<T, 3>& fraction) {
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto settle = [&](std::size_t i) {
        if (fraction[order[i + 1]] > fraction[order[i]]) {
            std::swap(order[i], order[i + 1]);
        }
    };
    settle(0);
    settle(1);
    settle(0);
    return order;
}

/// A curve is always interpolated linearly; `Interpolation` chooses how the cube is.
Rgb evaluate(const Lut1D& curve, Rgb in);
Rgb evaluate(const Lut3D& cube, Rgb in, Interpolation how);
Rgb evaluate(const Lut& lut, Rgb in, Interpolation how = Interpolation::tetrahedral);

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
RgbD evaluate_exact(const Lut& lut, RgbD in, Interpolation how = Interpolation::tetrahedral);

} // namespace lutlib
