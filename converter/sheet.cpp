#include "converter/sheet.h"

#include "lutlib/plot/dot_font.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace converter {
namespace {

constexpr plot::Rgb8 bright{235, 235, 235}, pale{170, 170, 170};
/// A label has room for its figures, however small the picture is.
constexpr int least_cell = 160;

// Where everything stands.
struct Plan {
    Plan(int width_of_tile, int height_of_tile, std::size_t tiles, int most_columns)
        : cell(std::max(width_of_tile, least_cell)), tile_width(width_of_tile),
          tile_height(height_of_tile), columns(std::min(most_columns, static_cast<int>(tiles))),
          rows((static_cast<int>(tiles) + columns - 1) / columns), scale(std::max(1, cell / 200)),
          margin(6 * scale), line(plot::line_step * scale) {}

    int label() const { return 2 * line; }
    int width() const { return columns * (cell + margin) + margin; }
    int headline() const { return margin + line; }
    int row_height() const { return tile_height + margin / 2 + label() + margin; }
    int height() const { return headline() + margin / 2 + rows * row_height(); }
    int left(std::size_t i) const {
        return margin + static_cast<int>(i) % columns * (cell + margin);
    }
    int top(std::size_t i) const {
        return headline() + margin / 2 + static_cast<int>(i) / columns * row_height();
    }
    /// How many glyphs have room on so many pixels.
    std::size_t glyphs(int pixels) const {
        return static_cast<std::size_t>(pixels / (plot::glyph_step * scale));
    }

    int cell, tile_width, tile_height, columns, rows, scale, margin, line;
};

std::string fitted(const std::string& text, std::size_t most) {
    return plot::cut_in_the_middle(plot::glyphs_of(text), most);
}

} // namespace

int usual_columns(std::size_t tiles) {
    return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tiles))));
}

std::size_t sheet_pixels(int tile_width, int tile_height, std::size_t tiles, int columns) {
    const Plan plan(tile_width, tile_height, tiles, columns);
    return static_cast<std::size_t>(plan.width()) * static_cast<std::size_t>(plan.height());
}

plot::Raster sheet_of(const std::string& headline, const std::vector<LabelledTile>& tiles,
                      int columns) {
    const plot::Raster& any = tiles.front().picture;
    const Plan plan(any.width(), any.height(), tiles.size(), columns);
    plot::Raster out(plan.width(), plan.height(), sheet_ground);
    out.write(fitted(headline, plan.glyphs(plan.width() - 2 * plan.margin)), plan.margin,
              plan.margin, plan.scale, bright);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const LabelledTile& tile = tiles[i];
        const int x = plan.left(i), y = plan.top(i);
        out.place(tile.picture, x, y);
        const int below = y + plan.tile_height + plan.margin / 2;
        const std::size_t most = plan.glyphs(plan.cell);
        out.write(fitted(tile.name, most), x, below, plan.scale, bright);
        out.write(fitted(tile.line, most), x, below + plan.line, plan.scale, pale);
    }
    return out;
}

std::vector<std::string> short_names_of(const std::vector<std::string>& paths) {
    std::vector<std::string> stems, names, out;
    for (const std::filesystem::path path : paths) {
        stems.push_back(path.stem().string());
        names.push_back(path.filename().string());
    }
    const auto is_alone = [](const std::vector<std::string>& all, const std::string& one) {
        return std::count(all.begin(), all.end(), one) == 1;
    };
    for (std::size_t i = 0; i < paths.size(); ++i) {
        out.push_back(is_alone(stems, stems[i])   ? stems[i]
                      : is_alone(names, names[i]) ? names[i]
                                                  : paths[i]);
    }
    return out;
}

} // namespace converter
