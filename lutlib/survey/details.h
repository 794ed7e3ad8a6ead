// Where a way of keeping a look errs: on planes through its colours, around its worst colour, on
// the colours that people look at, and along a gradient.
#pragma once

#include "lutlib/rgb.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lutlib {

/// A grid of colours, the first row at the bottom.
struct DetailPlane {
    std::string name, title, x_label, y_label;
    std::vector<std::optional<Rgb>> inputs; ///< none where the plane leaves the domain
};

/// A colour with a name. `srgb` is what a display shows of it before the look.
struct DetailPatch {
    std::string group, name;
    Rgb in;
    RgbD srgb;
};

inline constexpr int plane_cells = 16; ///< a side of a plane
inline constexpr int cell_parts = 5;   ///< each way within a cell of the lattice
inline constexpr int near_cells = 3 * cell_parts;
inline constexpr int gradient_columns = 48;
inline constexpr std::array<int, 3> gradient_bits{8, 10, 12};
/// By how much a gradient's errors are enlarged.
inline constexpr double gradient_magnification = 16;
/// The shares of colours whose errors are told.
inline constexpr std::array<double, 18> detail_shares{0.005, 0.02, 0.05, 0.1,   0.2,   0.3,
                                                      0.4,   0.5,  0.6,  0.7,   0.8,   0.9,
                                                      0.95,  0.98, 0.99, 0.995, 0.999, 1};

/// What is the same for every combination.
struct DetailColors {
    std::vector<DetailPlane> planes;  ///< r = g, across the neutral axis, hue against lightness
    std::vector<DetailPatch> patches; ///< ColorChecker, skin, neutrals
    /// Along the neutral axis of the domain, per depth: what codes of that depth alone make of the
    /// exact look, in and out; enlarged, about 0.5 a channel.
    std::array<std::vector<RgbD>, gradient_bits.size()> before;
    std::vector<RgbD> gradient; ///< the exact look of it
};

/// What one combination makes of them.
struct Details {
    std::vector<std::vector<double>> planes;           ///< errors, NaN where there is no colour
    std::vector<double> patches;                       ///< errors
    std::array<double, detail_shares.size()> shares{}; ///< the error that so many do not exceed
    Rgb worst;                                         ///< the input with the largest error ...
    double worst_error = 0;
    std::array<int, 3> worst_cell{}; ///< ... its cell in the lattice, from 0
    /// Errors in its cell and the eight around it, along red and green with blue as it is; NaN
    /// outside the lattice.
    std::vector<double> near_worst;
    std::array<std::vector<RgbD>, gradient_bits.size()> after; ///< as DetailColours::before
};

} // namespace lutlib
