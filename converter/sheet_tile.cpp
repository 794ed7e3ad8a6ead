#include "converter/sheet_tile.h"

#include "converter/side_by_side.h"
#include "lutlib/bake/bake.h"
#include "lutlib/metrics/viewing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace converter {
namespace {

namespace io = lutlib::io;

// Onto which of the fewer cells a sample falls, and with how much of it; the rest falls onto the
// next one. Shares are of a cell.
struct Cover {
    std::size_t cell = 0;
    double here = 0, next = 0;
};

std::vector<Cover> covers(int samples, int cells) {
    const double step = static_cast<double>(cells) / samples;
    std::vector<Cover> out(static_cast<std::size_t>(samples));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double begin = static_cast<double>(i) * step;
        const double border = std::floor(begin) + 1;
        const double here = std::min(step, border - begin);
        out[i] = {static_cast<std::size_t>(begin), here, step - here};
    }
    return out;
}

// Sums light, multiplied by alpha, over the cells of a tile.
class Reduction {
  public:
    Reduction(const io::ImageInfo& picture, TileSize size)
        : size_(size), across_(covers(picture.width, size.width)),
          down_(covers(picture.height, size.height)),
          cells_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

    void add_row(std::size_t y, const lutlib::RgbD* light, const float* rgba) {
        const Cover& down = down_[y];
        for (std::size_t x = 0; x < across_.size(); ++x) {
            const Cover& across = across_[x];
            const float alpha = rgba[4 * x + 3]; // NaN as none
            const Cell sample{light[x], alpha > 0 ? std::min(static_cast<double>(alpha), 1.0) : 0};
            for (const auto& [row, share] :
                 {std::pair(down.cell, down.here), std::pair(down.cell + 1, down.next)}) {
                add(across.cell, row, sample, share * across.here);
                add(across.cell + 1, row, sample, share * across.next);
            }
        }
    }

    plot::Raster picture(plot::Rgb8 behind) const {
        plot::Raster out(size_.width, size_.height, behind);
        const lutlib::Encoding& srgb = lutlib::srgb();
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            plot::Rgb8& pixel =
                out.at(static_cast<int>(i) % size_.width, static_cast<int>(i) / size_.width);
            for (std::size_t c = 0; c < 3; ++c) {
                const double under = srgb.decode(behind[c] / 255.0) * (1 - cells_[i].alpha);
                const double code = srgb.encode(cells_[i].light[c] + under);
                pixel[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(code, 0.0, 1.0)));
            }
        }
        return out;
    }

  private:
    struct Cell {
        lutlib::RgbD light;
        double alpha = 0;
    };

    void add(std::size_t x, std::size_t y, const Cell& sample, double share) {
        // What rounding leaves for a cell beyond the last is nothing to speak of.
        const auto width = static_cast<std::size_t>(size_.width);
        if (share <= 0 || x >= width || y >= static_cast<std::size_t>(size_.height)) {
            return;
        }
        Cell& cell = cells_[y * width + x];
        for (std::size_t c = 0; c < 3; ++c) {
            cell.light[c] += share * sample.alpha * sample.light[c];
        }
        cell.alpha += share * sample.alpha;
    }

    TileSize size_;
    std::vector<Cover> across_, down_;
    std::vector<Cell> cells_;
};

constexpr std::size_t colors_at_once = 1 << 17;

std::vector<lutlib::RgbD> colors_of(const float* rgba, std::size_t pixels,
                                    const lutlib::Transform& shown) {
    std::vector<lutlib::RgbD> out(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        out[i] = lutlib::to_double({rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]});
    }
    lutlib::apply_in_parallel(shown, out);
    return out;
}

} // namespace

TileSize tile_size_of(const io::ImageInfo& picture, int width) {
    TileSize out{std::min(width, picture.width), 0};
    const double height = static_cast<double>(picture.height) * out.width / picture.width;
    out.height = std::max(1, static_cast<int>(std::lround(height)));
    return out;
}

Tile make_tile(const io::FloatImage& straight, const lutlib::Transform& original,
               const lutlib::Transform& shown, TileSize size, plot::Rgb8 behind) {
    const auto width = static_cast<std::size_t>(straight.width);
    const std::size_t height = straight.pixels() / width;
    const std::size_t rows_at_once = std::max<std::size_t>(1, colors_at_once / width);
    const lutlib::Transform before = held_to_codes(original), after = held_to_codes(shown);
    const lutlib::Eye eye{lutlib::Viewing()};
    Reduction reduction(straight, size);
    std::vector<double> all, errors;
    for (std::size_t first = 0; first < height; first += rows_at_once) {
        const std::size_t rows = std::min(rows_at_once, height - first);
        const float* const rgba = straight.rgba.data() + 4 * first * width;
        std::vector<lutlib::RgbD> colors = colors_of(rgba, rows * width, after);
        errors.resize(colors.size());
        eye(lutlib::Metric::delta_e_2000, colors_of(rgba, rows * width, before), colors, errors);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            if (rgba[4 * i + 3] > 0) {
                all.push_back(errors[i]);
            }
        }
        lutlib::srgb().decode_all(colors);
        for (std::size_t row = 0; row < rows; ++row) {
            reduction.add_row(first + row, colors.data() + row * width, rgba + 4 * row * width);
        }
    }
    return {reduction.picture(behind), lutlib::error_stats(std::move(all))};
}

std::vector<Tile> make_tiles(const io::FloatImage& straight, const lutlib::Transform& original,
                             std::span<const lutlib::Transform> shown, TileSize size,
                             plot::Rgb8 behind, std::size_t at_once) {
    std::vector<Tile> out(shown.size());
    do_side_by_side(shown.size(), at_once, [&](std::size_t i) {
        out[i] = make_tile(straight, original, shown[i], size, behind);
    });
    return out;
}

std::size_t bytes_of_tile(const io::ImageInfo& picture, TileSize size) {
    const std::size_t cells =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    const std::size_t colors = std::max(colors_at_once, static_cast<std::size_t>(picture.width));
    // An error of each pixel, light of each cell, and the colours of a piece before and after.
    return sizeof(double) * picture.pixels() + 4 * sizeof(double) * cells +
           (2 * sizeof(lutlib::RgbD) + sizeof(double)) * colors;
}

} // namespace converter
