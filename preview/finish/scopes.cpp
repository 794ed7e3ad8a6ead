#include "preview/finish/scopes.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

// In dots.
constexpr int border = 4;
constexpr int between = 6; ///< plots of a parade
constexpr int beside_figures = 2;

constexpr std::array<std::string_view, 5> quarters{"0", "25", "50", "75", "100"};

/// The 75 % bars by name, with Cb and Cr by BT.709 as in shaders/scope_draw_vectorscope.comp.
struct Bar {
    std::string_view name;
    double r, g, b;
};
constexpr std::array<Bar, 6> bars{{{"R", 1, 0, 0},
                                   {"MG", 1, 0, 1},
                                   {"B", 0, 0, 1},
                                   {"CY", 0, 1, 1},
                                   {"G", 0, 1, 0},
                                   {"YL", 1, 1, 0}}};

std::vector<ScopeLabel> bar_labels(const ScopePlot& plot, FigureSize figures) {
    std::vector<ScopeLabel> labels;
    const double scale = plot.width / 1.06;
    for (const Bar& bar : bars) {
        const double luma = 0.2126 * bar.r + 0.7152 * bar.g + 0.0722 * bar.b;
        const double cb = 0.75 * (bar.b - luma) / 1.8556, cr = 0.75 * (bar.r - luma) / 1.5748;
        // Beside its box, on the side away from the vertical axis.
        const double gap = 0.02 * scale + beside_figures * plot.dot;
        const double width = static_cast<double>(bar.name.size()) * figures.advance;
        const double left = cb < 0 ? cb * scale - gap - width : cb * scale + gap;
        labels.push_back({bar.name, static_cast<std::int32_t>(plot.x + 0.5 * plot.width + left),
                          static_cast<std::int32_t>(plot.y + 0.5 * plot.height - cr * scale -
                                                    0.5 * figures.height)});
    }
    return labels;
}

} // namespace

ScopePlot scope_plot(const Scope& scope, std::uint32_t width, std::uint32_t height,
                     std::optional<FigureSize> figures) {
    const int w = static_cast<int>(width), h = static_cast<int>(height);
    ScopePlot plot;
    plot.dot = std::max((std::min(w, h) + 120) / 200, 1);
    const FigureSize figure = figures.value_or(dotted_figures(plot));
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
        plot.x += 3 * figure.advance + beside_figures * plot.dot;
        plot.width = std::max((w - plot.x - edge - (planes - 1) * gap) / planes, 1);
        plot.stride = scope.is_overlaid ? 0 : plot.width + gap;
    } else {
        plot.width = std::max(w - 2 * edge, 1);
        plot.height = std::max(plot.height - figure.height - beside_figures * plot.dot, 1);
    }
    return plot;
}

std::vector<ScopeLabel> scope_labels(const Scope& scope, const ScopePlot& plot,
                                     FigureSize figures) {
    if (scope.bins == ScopeBins::chroma) {
        return bar_labels(plot, figures);
    }
    std::vector<ScopeLabel> labels;
    const int gap = beside_figures * plot.dot;
    const bool upwards = scope.bins == ScopeBins::columns;
    // Where quarters have no room beside each other, halves; else the ends alone.
    const int room = upwards ? plot.height : plot.width;
    // Across, the last figure ends where its line is.
    const int taken = (upwards ? figures.height : 4 * figures.advance) + gap;
    const std::size_t step = room >= 4 * taken ? 1 : room >= 2 * taken ? 2 : 4;
    for (std::size_t i = 0; i < quarters.size(); i += step) {
        const auto quarter = static_cast<int>(i);
        const int width = static_cast<int>(quarters[i].size()) * figures.advance;
        ScopeLabel label{quarters[i], plot.x - gap - width, plot.y + plot.height + gap};
        if (scope.bins == ScopeBins::columns) {
            label.y =
                std::clamp(plot.y + plot.height - plot.height * quarter / 4 - figures.height / 2,
                           plot.y, std::max(plot.y, plot.y + plot.height - figures.height));
        } else {
            label.x = std::clamp(plot.x + plot.width * quarter / 4 - width / 2, plot.x,
                                 std::max(plot.x, plot.x + plot.width - width));
        }
        labels.push_back(label);
    }
    return labels;
}

} // namespace preview
