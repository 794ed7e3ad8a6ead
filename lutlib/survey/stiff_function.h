// Stiff and extreme looks as functions, exact at every colour: what a lattice's error is measured
// against where a LUT as reference would share its nodes with the lattice.
#pragma once

#include "lutlib/rgb.h"

#include <span>
#include <string_view>

namespace lutlib {

/// A curve whose feature (a step, a kink, black) stands at `place`.
struct StiffProfile {
    std::string_view name;
    std::string_view help;
    double place; ///< where the feature stands when it is not moved
    /// The exponent p of the largest error's fall with the cell's width, h^p, that theory gives for
    /// linear interpolation: 2 where the second derivative is bounded, 1 at a kink, the Hoelder
    /// exponent where there is no bounded first. Below 0: none, as features are narrower than the
    /// cells of usual lattices.
    double order;
    double (*at)(double t, double place);
    /// Of colours instead, where it is no curve; null else.
    RgbD (*of_color)(RgbD c, double place);
};
std::span<const StiffProfile> stiff_profiles();

/// How a curve is applied to colours.
enum class StiffAxis {
    channel, ///< each channel by itself: cells and feature are parallel
    mixed,   ///< each output of a weighted mean of the channels: the feature crosses cells at all
             ///< phases
};

struct StiffFunction {
    const StiffProfile* profile = nullptr;
    StiffAxis axis = StiffAxis::channel;
    double place = 0;

    RgbD operator()(RgbD c) const;
    /// What the curve of output `channel` is taken of.
    double argument(RgbD c, std::size_t channel) const;
    /// A colour of 0..1 related to `c` at which the first channel's argument is `t`, held to 0..1.
    RgbD with_argument(RgbD c, double t) const;
};

/// How a lattice's largest error is bounded before anything is measured.
struct StiffBound {
    double slope = 0;     ///< largest |g'| seen between points 1e-4 apart
    double curvature = 0; ///< largest |g''|, likewise
    const StiffFunction* function = nullptr;

    explicit StiffBound(const StiffFunction& function);

    /// Largest change of the curve over an interval of this width.
    double modulus(double width) const;
    /// Of an interpolation that gives a mean of a cell's nodes and is exact for linear functions,
    /// as trilinear and tetrahedral are. A curve g of a weighted mean whose weights have the sum 1
    /// has arguments within h in a cell of width h; with shares l_i of arguments t_i about t,
    ///   |sum l_i g(t_i) - g(t)| <= max|g''|/2 sum l_i (t_i - t)^2 <= h^2/8 max|g''|   (Popoviciu)
    ///                           <= max|g'| sum l_i |t_i - t|      <= h/2 max|g'|
    ///                           <= modulus(h):
    /// the least of the three.
    double of_means(double h) const;
    /// Of the nearest node, which lies within h/2.
    double of_nearest(double h) const { return modulus(h / 2); }
};

} // namespace lutlib
