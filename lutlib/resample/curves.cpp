#include "lutlib/resample/curves.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// Places within each step at which a table is held against what it stands for: none is the middle
// alone, which a function that is odd about it would pass.
constexpr double places[] = {0.21, 0.5, 0.83};

RgbD between(const Lut1D& curve, int i, double t) {
    return entry_position(curve, i) * (1 - t) + entry_position(curve, i + 1) * t;
}

/// The largest difference of a channel between the steps' ends, as a share of the channel's range.
double error_between(const Lut1D& curve, const Transform& transform) {
    Rgb low = curve.entries.front(), high = low;
    for (const Rgb& entry : curve.entries) {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], entry[c]);
            high[c] = std::max(high[c], entry[c]);
        }
    }
    std::vector<RgbD> wanted;
    for (int i = 0; i + 1 < curve.size(); ++i) {
        for (const double t : places) {
            wanted.push_back(between(curve, i, t));
        }
    }
    const std::vector<RgbD> inputs = wanted;
    transform(wanted);
    double most = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const RgbD error = evaluate_exact(curve, inputs[i]) - wanted[i];
        for (std::size_t c = 0; c < 3; ++c) {
            const double range = static_cast<double>(high[c]) - static_cast<double>(low[c]);
            most = std::max(most, range > 0 ? std::abs(error[c]) / range : std::abs(error[c]));
        }
    }
    return most;
}

} // namespace

bool is_curves(const Lut& lut) {
    return !lut.cube.has_value();
}

Lut1D sample_curve(const Transform& transform, const Domain& domain, int size) {
    check_shaper_size(size);
    check_domain(domain);
    Lut1D out{domain, std::vector<Rgb>(static_cast<std::size_t>(size))};
    std::vector<RgbD> colors;
    for (int i = 0; i < size; ++i) {
        colors.push_back(entry_position(out, i));
    }
    transform(colors);
    std::transform(colors.begin(), colors.end(), out.entries.begin(), to_float);
    return out;
}

Lut1D sample_curve_closely(const Transform& transform, const Domain& domain, int least,
                           double tolerance) {
    // An error no more than this times the least is as good: nothing brings a jump nearer.
    constexpr double as_good = 1.05;
    std::vector<std::pair<Lut1D, double>> tried;
    double smallest = INFINITY;
    for (int size = least; size <= limits::max_shaper_size && smallest > tolerance;
         size = 2 * size - 1) {
        Lut1D curve = sample_curve(transform, domain, size);
        const double error = error_between(curve, transform);
        smallest = std::min(smallest, error);
        tried.emplace_back(std::move(curve), error);
    }
    const double enough = std::max(tolerance, as_good * smallest);
    return std::find_if(tried.begin(), tried.end(),
                        [&](const auto& one) { return one.second <= enough; })
        ->first;
}

} // namespace lutlib
