// The 24 patches of a ColorChecker that was photographed.
#pragma once

#include "lutlib/engine/layout.h"

#include <array>
#include <span>
#include <vector>

namespace lutlib {

inline constexpr std::size_t chart_patches = 24;

/// Pixels of a picture that a chart covers, from the outer edges of its outer patches.
struct ChartArea {
    int left = 0, top = 0, width = 0, height = 0;
};

/// The codes that its maker publishes, in sRGB (color/swatches.h), in order.
std::array<RgbD, chart_patches> published_chart();

/// The medians of the middles of the patches, in the order of published_chart(), whichever way the
/// chart lies: upright, on its head, on a side, mirrored. That is told by the lightness of the
/// patches, which any grade but a negative keeps apart. Throws Error for an area that is not within
/// the picture or smaller than 24x16 pixels, and where no chart lies in it.
std::array<RgbD, chart_patches> chart_in(const Picture& picture, const ChartArea& area);

} // namespace lutlib
