// Statistics of a set of errors, the same everywhere a figure is printed.
#pragma once

#include "lutlib/rgb.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lutlib {

/// Of absolute values. Percentiles are the smallest value that at least that share does not exceed.
struct ErrorStats {
    double max = 0, p99 = 0, p95 = 0, mean = 0;
    std::size_t count = 0;
    std::size_t worst = 0; ///< index of the maximum
    /// Where the maximum was looked for elsewhere than among the `count` values: at which colour it
    /// was found, and whether a larger one may lie where nobody looked.
    std::optional<Rgb> at = {};
    bool largest_seen = false;
};

/// Values are taken absolute; a NaN counts as +Inf. An empty set gives zeros.
ErrorStats error_stats(std::vector<double> errors);

} // namespace lutlib
