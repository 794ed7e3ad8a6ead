#include "lutlib/plot/raster.h"

#include "lutlib/plot/dot_font.h"

#include <algorithm>

namespace plot {

Raster::Raster(int width, int height, Rgb8 color)
    : width_(width), height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), color) {}

void Raster::fill(int x, int y, int width, int height, Rgb8 color) {
    for (int row = std::max(y, 0); row < std::min(y + height, height_); ++row) {
        for (int column = std::max(x, 0); column < std::min(x + width, width_); ++column) {
            at(column, row) = color;
        }
    }
}

void Raster::place(const Raster& picture, int x, int y) {
    for (int row = std::max(y, 0); row < std::min(y + picture.height(), height_); ++row) {
        for (int column = std::max(x, 0); column < std::min(x + picture.width(), width_);
             ++column) {
            at(column, row) = picture.at(column - x, row - y);
        }
    }
}

void Raster::write(const std::string& glyphs, int x, int y, int scale, Rgb8 color) {
    for (const char glyph : glyphs) {
        for (int row = 0; row < glyph_height; ++row) {
            for (int column = 0; column < glyph_width; ++column) {
                if (has_dot(glyph, column, row)) {
                    fill(x + column * scale, y + row * scale, scale, scale, color);
                }
            }
        }
        x += glyph_step * scale;
    }
}

} // namespace plot
