#include "lutlib/engine/layout.h"

#include "lutlib/error.h"
#include "lutlib/limits.h"
#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

// Whole square root of n, or 0 when n is no square.
int square_root(int n) {
    const int root = static_cast<int>(std::lround(std::sqrt(n)));
    return root * root == n ? root : 0;
}

std::optional<PictureSize> strip_picture(int n) {
    return PictureSize{n * n, n};
}
Pixel strip_pixel(int n, int r, int g, int b) {
    return {b * n + r, g};
}
Pixel strip_up_pixel(int n, int r, int g, int b) {
    return {b * n + r, n - 1 - g};
}

constexpr int ocio_widest = 2048;

std::optional<PictureSize> ocio_picture(int n) {
    const int width = std::min(n * n, ocio_widest);
    const int nodes = n * n * n;
    return PictureSize{width, (nodes + width - 1) / width};
}
Pixel ocio_pixel(int n, int r, int g, int b) {
    const int width = std::min(n * n, ocio_widest);
    const int i = r + n * (g + n * b);
    return {i % width, i / width};
}

std::optional<PictureSize> hald_picture(int n) {
    const int level = square_root(n);
    return level ? std::optional(PictureSize{level * n, level * n}) : std::nullopt;
}
Pixel hald_pixel(int n, int r, int g, int b) {
    const int level = square_root(n);
    return {(g % level) * n + r, b * level + g / level};
}

std::optional<PictureSize> tiles_picture(int n) {
    const int per_row = square_root(n);
    return per_row ? std::optional(PictureSize{per_row * n, per_row * n}) : std::nullopt;
}
Pixel tiles_pixel(int n, int r, int g, int b) {
    const int per_row = square_root(n);
    return {(b % per_row) * n + r, (b / per_row) * n + g};
}

constexpr std::array<Layout, 5> table{{
    {"strip", "blue slices side by side, green down: Piccolo, Unreal, PlayCanvas, ReShade",
     strip_picture, strip_pixel},
    {"strip-up", "blue slices side by side, green up: Unity", strip_picture, strip_up_pixel},
    {"ocio", "nodes in row order, red fastest, at most 2048 wide: ociolutimage", ocio_picture,
     ocio_pixel},
    {"hald", "HALD of level sqrt(N): ffmpeg, ImageMagick, RawTherapee", hald_picture, hald_pixel},
    {"tiles", "blue slices in sqrt(N) rows, green down: OBS, GPUImage, Godot", tiles_picture,
     tiles_pixel},
}};

PictureSize picture_size(const Layout& layout, int n) {
    check_cube_size(n);
    const std::optional<PictureSize> size = layout.picture(n);
    if (!size) {
        throw Error("the layout '" + std::string(layout.name) + "' has no picture of size " +
                    std::to_string(n) + "; its sizes are square numbers (16, 25, 36, 49, 64, ...)");
    }
    return *size;
}

} // namespace

std::span<const Layout> layouts() {
    return table;
}

const Layout* layout_named(std::string_view name) {
    return find_named(table, name);
}

Picture to_picture(const Lut3D& cube, const Layout& layout) {
    const auto [width, height] = picture_size(layout, cube.size);
    Picture out{
        width, height,
        std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    for (int b = 0; b < cube.size; ++b) {
        for (int g = 0; g < cube.size; ++g) {
            for (int r = 0; r < cube.size; ++r) {
                const Pixel p = layout.pixel(cube.size, r, g, b);
                out.at(p.x, p.y) = cube.at(r, g, b);
            }
        }
    }
    return out;
}

Lut3D from_picture(const Picture& picture, const Layout& layout, int size, int row) {
    const auto [width, height] = picture_size(layout, size);
    if (picture.width != width || row < 0 || picture.height < height * (row + 1)) {
        throw Error("the layout '" + std::string(layout.name) + "' of size " +
                    std::to_string(size) + " is " + std::to_string(width) + "x" +
                    std::to_string(height) + "; this picture is " + std::to_string(picture.width) +
                    "x" + std::to_string(picture.height));
    }
    Lut3D cube = identity_cube(size);
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                const Pixel p = layout.pixel(size, r, g, b);
                cube.at(r, g, b) = picture.at(p.x, p.y + row * height);
            }
        }
    }
    return cube;
}

} // namespace lutlib
