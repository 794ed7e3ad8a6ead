// The exponent of a power law, from measured points.
#pragma once

#include <utility>
#include <vector>

namespace lutlib {

struct Slope {
    double value = 0;
    /// Half of its interval of 95 %; infinite where fewer than three points have a place.
    double interval = 0;
    std::size_t points = 0;
};

/// Least squares of log y on log x, with Student's interval for its slope (Draper and Smith,
/// "Applied Regression Analysis", 1998, section 1.4). Points below `floor`, where rounding rules,
/// are left out.
Slope slope_of(const std::vector<std::pair<double, double>>& points, double floor);

} // namespace lutlib
