// A contact sheet: tiles in rows under a headline, each with a name and a line below.
#pragma once

#include "lutlib/plot/raster.h"

#include <cstddef>
#include <string>
#include <vector>

namespace converter {

struct LabelledTile {
    plot::Raster picture;
    std::string name, line;
};

inline constexpr plot::Rgb8 sheet_ground{32, 32, 32};

/// How many tiles stand side by side where nobody says: as many as make the sheet nearly of the
/// tiles' shape.
int usual_columns(std::size_t tiles);

/// The size of a sheet in pixels, before one is made.
std::size_t sheet_pixels(int tile_width, int tile_height, std::size_t tiles, int columns);

/// All tiles have one size. Texts are UTF-8, and cut in the middle where they are too long.
plot::Raster sheet_of(const std::string& headline, const std::vector<LabelledTile>& tiles,
                      int columns);

/// A name for each file: its own without the extension, else with it, else its whole path, so that
/// no two are the same.
std::vector<std::string> short_names_of(const std::vector<std::string>& paths);

} // namespace converter
