#include "preview/finish/compare.h"

#include "lutlib/named.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace preview {

const Compare* compare_named(std::string_view name) {
    return lutlib::find_named(compares, name);
}

int index_of(const Compare& row) {
    return static_cast<int>(&row - compares.data());
}

Size picture_size(Size output, const Compare& compare) {
    return &compare == &compare_side ? Size{std::max(output.width / 2, 1U), output.height} : output;
}

DifferenceFigures difference_figures(std::span<const std::uint32_t> counted, std::uint64_t texels) {
    DifferenceFigures out;
    if (counted.empty() || texels == 0) {
        return out;
    }
    out.max = static_cast<double>(std::bit_cast<float>(counted[0]));
    const auto bins = counted.subspan(1);
    std::uint64_t above = 0;
    double sum = 0;
    const auto share = [&](double part) {
        return static_cast<std::uint64_t>(part * static_cast<double>(texels));
    };
    for (std::size_t bin = bins.size() - 1; bin > 0; --bin) {
        const double middle = (static_cast<double>(bin) + 0.5) / DifferenceBins::per_unit;
        sum += middle * static_cast<double>(bins[bin]);
        const std::uint64_t before = above;
        above += bins[bin];
        if (before <= share(0.01) && above > share(0.01)) {
            out.p99 = std::min(middle, out.max);
        }
        if (before <= share(0.05) && above > share(0.05)) {
            out.p95 = std::min(middle, out.max);
        }
    }
    out.mean = sum / static_cast<double>(texels);
    return out;
}

float heat_scale_for(const DifferenceFigures& figures) {
    return static_cast<float>(std::clamp(4 * std::ceil(figures.p99 / 4), 4.0, 96.0));
}

} // namespace preview
