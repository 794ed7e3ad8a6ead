#include "lutlib/survey/display.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace lutlib {
namespace {

constexpr std::array<std::string_view, 7> display_curves{"srgb",    "rec709", "gamma22", "gamma24",
                                                         "gamma26", "pq",     "hlg"};

} // namespace

bool is_for_displays(const Encoding& encoding) {
    return std::find(display_curves.begin(), display_curves.end(), encoding.curve->name) !=
           display_curves.end();
}

OutsideDisplay outside_display(const std::vector<RgbD>& results) {
    OutsideDisplay out;
    std::size_t count = 0;
    for (const RgbD& c : results) {
        const double distance = largest_magnitude(c - saturate(c));
        count += distance > 0;
        out.most = std::max(out.most, distance);
    }
    if (!results.empty()) {
        out.share = static_cast<double>(count) / static_cast<double>(results.size());
    }
    return out;
}

} // namespace lutlib
