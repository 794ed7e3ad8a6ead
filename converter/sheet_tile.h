// A picture under a look, as a tile of a contact sheet.
#pragma once

#include "lutlib/io/image.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/plot/raster.h"
#include "lutlib/transform.h"

#include <cstddef>
#include <span>
#include <vector>

namespace converter {

struct Tile {
    plot::Raster picture{0, 0, {}};
    lutlib::ErrorStats delta_e_2000; ///< of the whole picture's pixels, but those of alpha 0
};

/// The tile's size: as wide as asked for, but no wider than the picture, of its shape.
struct TileSize {
    int width = 0, height = 0;
};
TileSize tile_size_of(const lutlib::io::ImageInfo& picture, int width);

/// Both transforms take the picture's straight colours to sRGB codes, which are held to 0..1: a
/// display shows no others. The error is `shown` against `original`. Pixels are averaged in linear
/// light, each by the area that it covers; `behind` lies under what is transparent.
Tile make_tile(const lutlib::io::FloatImage& straight, const lutlib::Transform& original,
               const lutlib::Transform& shown, TileSize size, plot::Rgb8 behind);

/// A tile for each of `shown`, at most `at_once` made at the same time: those of make_tile().
std::vector<Tile> make_tiles(const lutlib::io::FloatImage& straight,
                             const lutlib::Transform& original,
                             std::span<const lutlib::Transform> shown, TileSize size,
                             plot::Rgb8 behind, std::size_t at_once);

/// What one takes while it is made.
std::size_t bytes_of_tile(const lutlib::io::ImageInfo& picture, TileSize size);

} // namespace converter
