#include "lutlib/metrics/peak.h"

#include "lutlib/metrics/samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

constexpr std::size_t climbers = 32;
constexpr int steps = 48;
constexpr float shrink = 0.93F;

} // namespace

double peak_error(const std::vector<Rgb>& colours, const Domain& domain, float step,
                  const std::function<double(Rgb)>& error_of) {
    if (colours.empty()) {
        return 0;
    }
    std::vector<std::pair<double, std::size_t>> falling(colours.size());
    tbb::parallel_for(std::size_t{0}, colours.size(), [&](std::size_t i) {
        const double error = error_of(colours[i]);
        falling[i] = {std::isnan(error) ? -INFINITY : -error, i};
    });
    const std::size_t count = std::min(climbers, falling.size());
    std::partial_sort(falling.begin(), falling.begin() + static_cast<std::ptrdiff_t>(count),
                      falling.end());
    const std::vector<Rgb> directions =
        sample_colors(2, {.neutral = 2, .random = steps, .lattice = false});
    std::vector<double> peaks(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
        Rgb at = colours[falling[k].second];
        double peak = -falling[k].first;
        float reach = step;
        for (const Rgb& direction : directions) {
            Rgb next = at;
            for (std::size_t c = 0; c < 3; ++c) {
                const float width = domain.max[c] - domain.min[c];
                next[c] = std::clamp(at[c] + (direction[c] - 0.5F) * reach * width, domain.min[c],
                                     domain.max[c]);
            }
            const double found = error_of(next);
            if (found > peak) {
                peak = found;
                at = next;
            } else {
                reach *= shrink;
            }
        }
        peaks[k] = peak;
    });
    return *std::max_element(peaks.begin(), peaks.end());
}

} // namespace lutlib
