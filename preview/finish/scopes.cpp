#include "preview/finish/scopes.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

// In dots of the figures, which are 5 wide, 6 high and 6 apart.
constexpr int label_width = 3 * 6 + 3;
constexpr int label_height = 6 + 2;
constexpr int border = 4;
constexpr int between = 6; ///< plots of a parade

/// Columns of a picture that is A on one side of a line and B on the other. The line is as wide as
/// shaders/common/finish.glsl draws it, and antialiasing blends one texel beside it.
ColumnRange beside_line(bool left, float split, std::uint32_t width, std::uint32_t height) {
    const double line = static_cast<double>(split) * width;
    const double reach = std::max(height / 1080.0, 0.5) + 1;
    const auto column = [&](double x) {
        return static_cast<std::uint32_t>(std::clamp(x, 0.0, static_cast<double>(width)));
    };
    if (left) {
        return {0, column(std::ceil(line - reach - 0.5))};
    }
    const std::uint32_t first = column(std::floor(line + reach - 0.5) + 1);
    return {first, width - first};
}

} // namespace

ColumnRange scope_range(const ScopeSide& side, const Compare& compare, float split,
                        std::uint32_t width, std::uint32_t height) {
    if (&compare == &compare_difference) {
        return {};
    }
    if (&side == &scope_side_shown) {
        return {0, width};
    }
    const bool is_a = &side == &scope_sides[1];
    if (!(is_a ? compare.shows_a : compare.shows_b)) {
        return {};
    }
    if (!compare.shows_a || !compare.shows_b) {
        return {0, width};
    }
    if (&compare == &compare_side) {
        return {is_a ? 0 : width / 2, width / 2};
    }
    return beside_line(is_a, split, width, height);
}

ScopePlot scope_plot(const Scope& scope, std::uint32_t width, std::uint32_t height) {
    const int w = static_cast<int>(width), h = static_cast<int>(height);
    ScopePlot plot;
    plot.dot = std::max((std::min(w, h) + 120) / 200, 1);
    const int edge = border * plot.dot;
    if (scope.bins == ScopeBins::chroma) {
        plot.width = plot.height = std::max(std::min(w, h) - 2 * edge, 1);
        plot.x = (w - plot.width) / 2;
        plot.y = (h - plot.height) / 2;
        return plot;
    }
    plot.y = edge;
    plot.height = std::max(h - 2 * edge, 1);
    plot.x = edge;
    if (scope.bins == ScopeBins::columns) {
        const int planes = scope.is_overlaid ? 1 : static_cast<int>(scope.planes);
        const int gap = between * plot.dot;
        plot.x += label_width * plot.dot;
        plot.width = std::max((w - plot.x - edge - (planes - 1) * gap) / planes, 1);
        plot.stride = scope.is_overlaid ? 0 : plot.width + gap;
    } else {
        plot.width = std::max(w - 2 * edge, 1);
        plot.height = std::max(plot.height - label_height * plot.dot, 1);
    }
    return plot;
}

} // namespace preview
