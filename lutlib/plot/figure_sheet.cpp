#include "lutlib/plot/figure_sheet.h"

#include "lutlib/plot/dot_font.h"

#include <algorithm>
#include <cmath>

namespace plot {
namespace {

constexpr Rgb8 headline_color{34, 34, 34}, further_color{90, 90, 90};
constexpr double margin = 8;
constexpr int most_columns = 3;

// Figures of a row; a wide one is alone.
std::vector<std::span<const Figure>> rows_of(std::span<const Figure> figures, int columns) {
    std::vector<std::span<const Figure>> out;
    for (std::size_t first = 0; first < figures.size();) {
        std::size_t end = first + 1;
        while (!figures[first].is_wide && end < figures.size() && !figures[end].is_wide &&
               end - first < static_cast<std::size_t>(columns)) {
            ++end;
        }
        out.push_back(figures.subspan(first, end - first));
        first = end;
    }
    return out;
}

int columns_for(double width, std::span<const Figure> figures) {
    const auto narrow = static_cast<int>(std::count_if(
        figures.begin(), figures.end(), [](const Figure& figure) { return !figure.is_wide; }));
    return std::clamp(static_cast<int>((width - margin) / (figure_width + margin)), 1,
                      std::clamp(narrow, 1, most_columns));
}

} // namespace

Drawing figure_sheet(std::span<const std::string> headlines, std::span<const Figure> figures,
                     double width) {
    const int columns = columns_for(width, figures);
    const double cell = (width - margin) / columns - margin;
    Drawing out;
    out.width = width;
    double y = margin;
    for (const std::string& line : headlines) {
        const bool is_first = &line == headlines.data();
        out.shapes.emplace_back(Words{{margin, y},
                                      line,
                                      Anchor::start,
                                      is_first ? headline_color : further_color,
                                      static_cast<std::size_t>((width - 2 * margin) / glyph_step),
                                      is_first});
        out.label += (is_first ? "" : "; ") + line;
        y += line_step;
    }
    for (const std::span<const Figure> row : rows_of(figures, columns)) {
        const bool is_wide = row.front().is_wide;
        const double height = is_wide ? wide_figure_height : cell * figure_height / figure_width;
        double x = margin;
        for (const Figure& figure : row) {
            out.add(drawing_of(figure, is_wide ? width - 2 * margin : cell, height), {x, y});
            x += cell + margin;
        }
        y += height + margin;
    }
    out.height = std::ceil(y);
    return out;
}

double sheet_dots(int pixels, std::span<const Figure> figures) {
    const auto needed = [&](int columns) { return columns * (figure_width + margin) + margin; };
    const int columns = columns_for(needed(most_columns), figures);
    return pixels / std::max(1.0, std::floor(pixels / needed(columns)));
}

} // namespace plot
