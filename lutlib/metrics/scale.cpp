#include "lutlib/metrics/scale.h"

#include <algorithm>
#include <cmath>

namespace lutlib {

std::optional<double> scale_between(const Transform& a, const Transform& b,
                                    std::span<const Rgb> inputs) {
    constexpr double tolerance = 1e-3;
    const std::vector<RgbD> left = images_of(a, inputs), right = images_of(b, inputs);
    double products = 0, squares = 0, largest = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            products += left[i][c] * right[i][c];
            squares += right[i][c] * right[i][c];
            largest = std::max(largest, std::abs(left[i][c]));
        }
    }
    const double scale = products / squares;
    if (!std::isfinite(scale) || !(scale > 0) || std::abs(scale - 1) < tolerance) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (!(largest_magnitude(left[i] - right[i] * scale) <= tolerance * largest)) {
            return std::nullopt;
        }
    }
    return scale;
}

} // namespace lutlib
