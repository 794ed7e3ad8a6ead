// A picture in double, and how the oracles sample it.
#pragma once

#include "lutlib/rgb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace preview::reference {

struct Image {
    int width = 0, height = 0;
    std::vector<lutlib::RgbD> pixels;

    Image() = default;
    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    lutlib::RgbD& at(int x, int y) { return pixels[index(x, y)]; }
    const lutlib::RgbD& at(int x, int y) const { return pixels[index(x, y)]; }

    /// Beyond its border a picture goes on as its border texels.
    const lutlib::RgbD& clamped(int x, int y) const {
        return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    }

    /// Bilinear, texel centres at half integers.
    lutlib::RgbD sample(double x, double y) const {
        const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5);
        const double u = x - 0.5 - fx, v = y - 0.5 - fy;
        const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
        return (clamped(ix, iy) * (1 - u) + clamped(ix + 1, iy) * u) * (1 - v) +
               (clamped(ix, iy + 1) * (1 - u) + clamped(ix + 1, iy + 1) * u) * v;
    }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

} // namespace preview::reference
