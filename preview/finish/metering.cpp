#include "preview/finish/metering.h"

#include "lutlib/half.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

constexpr double darkest = 1.0 / 4096;

double luma_of(const lutlib::RgbD& light) {
    return 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
}

} // namespace

std::optional<double> stops_to_grey(const lutlib::RgbD& light) {
    const double luma = luma_of(light);
    return luma > 0 && std::isfinite(luma) ? std::optional(std::log2(metered_grey / luma))
                                           : std::nullopt;
}

std::optional<double> stops_to_grey(std::span<const std::uint16_t> rgba) {
    double stops = 0, brightest = 0, count = 0;
    const auto channel = [&](std::size_t at) {
        return static_cast<double>(lutlib::float_from_half(rgba[at]));
    };
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4) {
        const double luma = luma_of({channel(at), channel(at + 1), channel(at + 2)});
        if (luma > 0) {
            stops += std::log2(std::max(luma, darkest));
            brightest = std::max(brightest, luma);
            ++count;
        }
    }
    if (brightest <= darkest) {
        return std::nullopt;
    }
    return std::log2(metered_grey) - stops / count;
}

} // namespace preview
