// How costs grow: what a pass takes against how much there is of what it works on, and the exponent
// of a power that fits.
#pragma once

#include "preview/report/renderer.h"

#include <string>
#include <vector>

namespace preview::report {

struct GrowthPoint {
    double amount = 0;
    lutlib::Timing time;
};

struct Growth {
    std::string name, amount_label; ///< "lights"
    std::string passes;             ///< that are timed, for people
    std::vector<GrowthPoint> points;
    /// time ~ amount^exponent by least squares of logarithms: of all points, and of the upper half
    /// of them, where what does not grow counts for less.
    double exponent = 0, upper_exponent = 0;
};

/// Time against pixels, lights from 1 to 4096, triangles, lights that cast shadows, and levels of
/// bloom. `situation` as studied; scenes are made for the purpose but for that of pixels.
std::vector<Growth> growth_of(Renderer& renderer, const Situation& situation, int rounds);

/// Exponent of the power of x that fits y, of two points and more; all above 0.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

} // namespace preview::report
