#include "lutlib/plot/value_axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plot {

double ValueAxis::at(double value) const {
    const double t = value > low ? std::min((value - low) / (high - low), 1.0) : 0;
    return std::lerp(start, end, t);
}

void Extent::add(double value) {
    if (!std::isfinite(value)) {
        return;
    }
    low = is_empty() ? value : std::min(low, value);
    high = std::max(is_empty() ? value : high, value);
}

void Extent::add(std::span<const double> values) {
    for (const double value : values) {
        add(value);
    }
}

Extent Extent::with_width() const {
    constexpr double most = std::numeric_limits<double>::max() / 8;
    if (is_empty()) {
        return {0, 1};
    }
    Extent out{std::max(low, -most), std::min(high, most)};
    // Narrower than what is told apart in a drawing, and than what doubles tell apart.
    const double least = 1e-9 * std::max(std::abs(out.low), std::abs(out.high));
    if (out.high - out.low <= least) {
        const double room = std::max(out.high == 0 ? 0.5 : 0.5 * std::abs(out.high), 1e-300);
        out = {std::max(out.low - room, -most), std::min(out.high + room, most)};
    }
    return out;
}

std::vector<double> round_values(const Extent& range, int most) {
    const double width = range.high - range.low;
    const double power = std::pow(10.0, std::floor(std::log10(width / most)));
    double step = 10 * power;
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (width / (digit * power) <= most) {
            step = digit * power;
            break;
        }
    }
    std::vector<double> out;
    const double first = std::ceil(range.low / step - 1e-9);
    for (int i = 0; i <= most; ++i) {
        const double value = (first + i) * step;
        if (value > range.high + 1e-9 * width) {
            break;
        }
        out.push_back(value);
    }
    return out;
}

std::string value_text(double value, const Extent& range) {
    const bool is_nothing = std::abs(value) < 1e-9 * (range.high - range.low);
    return fmt::format("{:.4g}", is_nothing ? 0 : value);
}

} // namespace plot
