#include "lutlib/resample/invert_shaper.h"

#include <algorithm>
#include <vector>

namespace lutlib {

Lut1D output_shaper(std::span<const RgbD> outputs, const Domain& domain, int size) {
    constexpr double even = 0.2, end = 1e-6;
    check_shaper_size(size);
    check_domain(domain);
    Lut1D out{domain, std::vector<Rgb>(static_cast<std::size_t>(size))};
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = domain.min[c], width = static_cast<double>(domain.max[c]) - low;
        std::vector<double> within;
        for (const RgbD& output : outputs) {
            const double at = (output[c] - low) / width;
            if (at > end && at < 1 - end) {
                within.push_back(at);
            }
        }
        std::sort(within.begin(), within.end());
        for (int i = 0; i < size; ++i) {
            const double at = static_cast<double>(i) / (size - 1);
            const auto below = std::lower_bound(within.begin(), within.end(), at) - within.begin();
            const double share =
                within.empty() ? at
                               : static_cast<double>(below) / static_cast<double>(within.size());
            out.entries[static_cast<std::size_t>(i)][c] =
                static_cast<float>(even * at + (1 - even) * share);
        }
    }
    return out;
}

} // namespace lutlib
