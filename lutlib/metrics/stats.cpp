#include "lutlib/metrics/stats.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lutlib {

ErrorStats error_stats(std::vector<double> errors) {
    ErrorStats out;
    out.count = errors.size();
    if (errors.empty()) {
        return out;
    }
    double sum = 0;
    for (double& e : errors) {
        e = std::isnan(e) ? std::numeric_limits<double>::infinity() : std::abs(e);
        sum += e;
    }
    out.mean = sum / static_cast<double>(errors.size());
    out.worst =
        static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());
    const auto percentile = [&](double share) {
        const double rank = std::ceil(share * static_cast<double>(errors.size()));
        const auto k = static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
        std::nth_element(errors.begin(), errors.begin() + k, errors.end());
        return errors[static_cast<std::size_t>(k)];
    };
    out.max = errors[out.worst];
    out.p99 = percentile(0.99);
    out.p95 = percentile(0.95);
    return out;
}

} // namespace lutlib
