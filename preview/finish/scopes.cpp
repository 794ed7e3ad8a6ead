#include "preview/finish/scopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preview {

namespace {

// In dots.
constexpr int border = 4;
constexpr int between = 6; ///< plots of a parade
constexpr int beside_figures = 2;

// Of the vectorscope, as shaders/scope_draw_vectorscope.comp has them.
constexpr double skin_angle = 123;    ///< degrees
constexpr double room_of_bars = 1.06; ///< about the circle, for the boxes at full colours

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

/// Beyond the circle, where the line ends.
ScopeLabel skin_label(const ScopePlot& plot, FigureSize figures) {
    constexpr double angle = skin_angle / 180 * std::numbers::pi;
    const std::string_view text = "Skin";
    const double away = 0.5 * plot.width / room_of_bars + beside_figures * plot.dot;
    const double width = static_cast<double>(text.size()) * figures.advance;
    const double x = plot.x + 0.5 * plot.width + std::cos(angle) * away - width;
    const double y = plot.y + 0.5 * plot.height - std::sin(angle) * away - figures.height;
    return {std::string(text), std::max(static_cast<std::int32_t>(x), 0),
            std::max(static_cast<std::int32_t>(y), 0)};
}

std::vector<ScopeLabel> chroma_labels(const ScopePlot& plot, FigureSize figures) {
    std::vector<ScopeLabel> labels;
    const double scale = plot.width / room_of_bars;
    for (const Bar& bar : bars) {
        const double luma = 0.2126 * bar.r + 0.7152 * bar.g + 0.0722 * bar.b;
        const double cb = 0.75 * (bar.b - luma) / 1.8556, cr = 0.75 * (bar.r - luma) / 1.5748;
        // Beside its box, on the side away from the vertical axis.
        const double gap = 0.02 * scale + beside_figures * plot.dot;
        const double width = static_cast<double>(bar.name.size()) * figures.advance;
        const double left = cb < 0 ? cb * scale - gap - width : cb * scale + gap;
        labels.push_back({std::string(bar.name),
                          static_cast<std::int32_t>(plot.x + 0.5 * plot.width + left),
                          static_cast<std::int32_t>(plot.y + 0.5 * plot.height - cr * scale -
                                                    0.5 * figures.height)});
    }
    labels.push_back(skin_label(plot, figures));
    return labels;
}

int widest(std::span<const LevelFigure> levels) {
    std::size_t most = 0;
    for (const LevelFigure& figure : levels) {
        most = std::max(most, figure.text.size());
    }
    return static_cast<int>(most);
}

/// Of which figures, from the uppermost, there is room for: of every one, every second, every
/// fourth...
std::size_t step_between(std::span<const LevelFigure> levels, double taken) {
    std::size_t step = 1;
    const auto is_tight = [&] {
        for (std::size_t i = levels.size() - 1; i >= step; i -= step) {
            if (levels[i].at - levels[i - step].at < taken) {
                return true;
            }
        }
        return false;
    };
    while (step + 1 < levels.size() && is_tight()) {
        step *= 2;
    }
    return step;
}

} // namespace

ScopePlot scope_plot(const Scope& scope, std::uint32_t width, std::uint32_t height,
                     std::optional<FigureSize> figures, std::span<const LevelFigure> levels) {
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
        plot.x += widest(levels) * figure.advance + beside_figures * plot.dot;
        plot.width = std::max((w - plot.x - edge - (planes - 1) * gap) / planes, 1);
        plot.stride = scope.is_overlaid ? 0 : plot.width + gap;
    } else {
        plot.width = std::max(w - 2 * edge, 1);
        plot.height = std::max(plot.height - figure.height - beside_figures * plot.dot, 1);
    }
    return plot;
}

std::vector<ScopeLabel> scope_labels(const Scope& scope, const ScopePlot& plot, FigureSize figures,
                                     std::span<const LevelFigure> levels) {
    if (!has_levels(scope)) {
        return chroma_labels(plot, figures);
    }
    std::vector<ScopeLabel> labels;
    const int gap = beside_figures * plot.dot;
    const bool upwards = scope.bins == ScopeBins::columns;
    const int room = upwards ? plot.height : plot.width;
    // Across, the last figure ends where its line is.
    const int taken = (upwards ? figures.height : (widest(levels) + 1) * figures.advance) + gap;
    const std::size_t step = step_between(levels, static_cast<double>(taken) / room);
    for (std::size_t i = (levels.size() - 1) % step; i < levels.size(); i += step) {
        const int along = static_cast<int>(room * levels[i].at);
        const int width = static_cast<int>(levels[i].text.size()) * figures.advance;
        ScopeLabel label{levels[i].text, plot.x - gap - width, plot.y + plot.height + gap};
        if (upwards) {
            label.y = std::clamp(plot.y + plot.height - along - figures.height / 2, plot.y,
                                 std::max(plot.y, plot.y + plot.height - figures.height));
        } else {
            label.x = std::clamp(plot.x + along - width / 2, plot.x,
                                 std::max(plot.x, plot.x + plot.width - width));
        }
        labels.push_back(std::move(label));
    }
    return labels;
}

} // namespace preview
