// Pictures of 8-bit codes that are put together of rectangles, other pictures and text. What lies
// outside of the picture is not drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace plot {

using Rgb8 = std::array<std::uint8_t, 3>;

class Raster {
  public:
    /// All of one colour.
    Raster(int width, int height, Rgb8 color);

    int width() const { return width_; }
    int height() const { return height_; }
    const Rgb8& at(int x, int y) const { return pixels_[index(x, y)]; }
    Rgb8& at(int x, int y) { return pixels_[index(x, y)]; }
    /// Rows from the top.
    const std::vector<Rgb8>& pixels() const { return pixels_; }

    void fill(int x, int y, int width, int height, Rgb8 color);
    void place(const Raster& picture, int x, int y);
    /// A line of glyphs (dot_font.h) whose first has its upper left corner at (x, y), each dot a
    /// square of `scale` pixels.
    void write(const std::string& glyphs, int x, int y, int scale, Rgb8 color);

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_, height_;
    std::vector<Rgb8> pixels_;
};

} // namespace plot
