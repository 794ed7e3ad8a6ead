// From colours with large errors to the largest near them.
#pragma once

#include "lutlib/metrics/error_samples.h"

#include <functional>
#include <span>

namespace lutlib {

/// Errors of colours, into a span of the same length. Called from several threads, with some
/// hundred colours at once.
using ErrorsOf = std::function<void(std::span<const Rgb> colors, std::span<double> errors)>;

struct Peak {
    double error = 0;
    Rgb at;
};

/// Uphill from the worst 1024 of the colours (errors[i] is that of colours[i]), no two of them in
/// one cell of the axes: again and again to the worst of 24 colours around, at first within a
/// cell's width, nearer where none is worse; the highest quarter goes on, then the highest of
/// those. Stays within the axes' ends. The same on every machine.
Peak climbed(std::span<const Rgb> colors, std::span<const double> errors,
             const std::array<std::vector<float>, 3>& axis, const ErrorsOf& errors_of);

} // namespace lutlib
