// Monotone fits of sequences.
#pragma once

#include <vector>

namespace lutlib {

/// The closest sequence that does not fall, by least squares (pool adjacent violators: Ayer et al.,
/// Annals of Mathematical Statistics 26(4), 1955).
std::vector<double> rising(const std::vector<double>& values);
/// The same where each value counts by its weight, as many as there are values, all above 0.
std::vector<double> rising(const std::vector<double>& values, const std::vector<double>& weights);

} // namespace lutlib
