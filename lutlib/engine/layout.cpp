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

// The one size that a full picture of these dimensions can have, or 0: its pixels are its nodes.
int size_of_full(PictureSize picture) {
    const double pixels = static_cast<double>(picture.width) * picture.height;
    const auto n = static_cast<int>(std::lround(std::cbrt(pixels)));
    const bool cubic = static_cast<double>(n) * n * n == pixels;
    return cubic && n >= limits::min_cube_size && n <= limits::max_cube_size ? n : 0;
}

std::optional<int> if_size(bool holds, int n) {
    return n > 0 && holds ? std::optional(n) : std::nullopt;
}

std::optional<PictureSize> strip_picture(int n) {
    return PictureSize{n * n, n};
}
std::optional<int> strip_lattice(PictureSize picture) {
    const int n = size_of_full(picture);
    return if_size(picture.height == n, n);
}
Pixel strip_pixel(int n, int /*width*/, int r, int g, int b) {
    return {b * n + r, g};
}
Pixel strip_up_pixel(int n, int /*width*/, int r, int g, int b) {
    return {b * n + r, n - 1 - g};
}

std::optional<PictureSize> strip_vertical_picture(int n) {
    return PictureSize{n, n * n};
}
std::optional<int> strip_vertical_lattice(PictureSize picture) {
    const int n = size_of_full(picture);
    return if_size(picture.width == n, n);
}

constexpr int ocio_widest = 2048;

std::optional<PictureSize> ocio_picture(int n) {
    const int width = std::min(n * n, ocio_widest);
    const int nodes = n * n * n;
    return PictureSize{width, (nodes + width - 1) / width};
}
std::optional<int> ocio_lattice(PictureSize picture) {
    // The last row need not be full.
    const auto n =
        static_cast<int>(std::cbrt(static_cast<double>(picture.width) * picture.height) + 1e-6);
    const bool possible = n >= limits::min_cube_size && n <= limits::max_cube_size;
    return if_size(possible && ocio_picture(n) == picture, n);
}
Pixel ocio_pixel(int n, int width, int r, int g, int b) {
    const int i = r + n * (g + n * b);
    return {i % width, i / width};
}

std::optional<PictureSize> hald_picture(int n) {
    const int level = square_root(n);
    return level ? std::optional(PictureSize{level * n, level * n}) : std::nullopt;
}
std::optional<int> hald_lattice(PictureSize picture) {
    const int n = size_of_full(picture);
    return if_size(picture.width == picture.height, n);
}
Pixel hald_pixel(int n, int /*width*/, int r, int g, int b) {
    const int level = square_root(n);
    return {(g % level) * n + r, b * level + g / level};
}

// Tiles lie in the grid nearest to a square that is no wider than it must be: 8 x 8, 8 x 4.
std::optional<PictureSize> tiles_picture(int n) {
    int down = square_root(n);
    for (down = down ? down : static_cast<int>(std::sqrt(n)); n % down != 0; --down) {
    }
    return down > 1 ? std::optional(PictureSize{n / down * n, down * n}) : std::nullopt;
}
// One row or one column of tiles are strips.
std::optional<int> tiles_lattice(PictureSize picture) {
    const int n = size_of_full(picture);
    return if_size(n > 0 && picture.width % n == 0 && picture.height % n == 0 &&
                       picture.width > n && picture.height > n,
                   n);
}
Pixel tiles_pixel(int n, int width, int r, int g, int b) {
    const int per_row = width / n;
    return {(b % per_row) * n + r, (b / per_row) * n + g};
}

constexpr std::string_view every_size = "any size";

constexpr std::array<Layout, 6> layout_rows{{
    {.name = "strip",
     .help = "blue slices side by side, green down: Piccolo, Unreal, PlayCanvas, ReShade",
     .sizes = every_size,
     .stacks = true,
     .picture = strip_picture,
     .lattice = strip_lattice,
     .pixel = strip_pixel},
    {.name = "strip-up",
     .help = "blue slices side by side, green up: Unity",
     .sizes = every_size,
     .stacks = true,
     .picture = strip_picture,
     .lattice = strip_lattice,
     .pixel = strip_up_pixel},
    {.name = "strip-vertical",
     .help = "blue slices below each other, green down: three.js, volume textures' raw order",
     .sizes = every_size,
     .stacks = false,
     .picture = strip_vertical_picture,
     .lattice = strip_vertical_lattice,
     .pixel = tiles_pixel},
    {.name = "ocio",
     .help = "nodes in row order, red fastest, at most 2048 wide: ociolutimage",
     .sizes = every_size,
     .stacks = false,
     .picture = ocio_picture,
     .lattice = ocio_lattice,
     .pixel = ocio_pixel},
    {.name = "hald",
     .help = "HALD of level sqrt(N): ffmpeg, ImageMagick, RawTherapee",
     .sizes = "square numbers (16, 25, 36, 49, 64, ...)",
     .stacks = false,
     .picture = hald_picture,
     .lattice = hald_lattice,
     .pixel = hald_pixel},
    {.name = "tiles",
     .help = "blue slices in rows of a grid, green down: OBS, GPUImage, Godot",
     .sizes = "numbers that are not prime (16, 32, 64, ...)",
     .stacks = false,
     .picture = tiles_picture,
     .lattice = tiles_lattice,
     .pixel = tiles_pixel},
}};

PictureSize picture_size(const Layout& layout, int n) {
    check_cube_size(n);
    const std::optional<PictureSize> size = layout.picture(n);
    if (!size) {
        throw Error("the layout '" + std::string(layout.name) + "' has no picture of size " +
                    std::to_string(n) + "; its sizes are " + std::string(layout.sizes));
    }
    return *size;
}

} // namespace

std::span<const Layout> layouts() {
    return layout_rows;
}

const Layout* layout_named(std::string_view name) {
    return find_named(layout_rows, name);
}

std::optional<Arrangement> arrangement_in(const Layout& layout, PictureSize picture) {
    if (const std::optional<int> size = layout.lattice(picture)) {
        return Arrangement{*size, 1};
    }
    const int n = square_root(picture.width);
    if (!layout.stacks || n < limits::min_cube_size || n > limits::max_cube_size ||
        picture.height % n != 0) {
        return std::nullopt;
    }
    return Arrangement{n, picture.height / n};
}

Picture to_picture(const Lut3D& cube, const Layout& layout) {
    const auto [width, height] = picture_size(layout, cube.size);
    Picture out{
        width, height,
        std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    for (int b = 0; b < cube.size; ++b) {
        for (int g = 0; g < cube.size; ++g) {
            for (int r = 0; r < cube.size; ++r) {
                const Pixel p = layout.pixel(cube.size, width, r, g, b);
                out.at(p.x, p.y) = cube.at(r, g, b);
            }
        }
    }
    return out;
}

Lut3D from_picture(const Picture& picture, const Layout& layout, int size, int row) {
    const std::optional<Arrangement> held = arrangement_in(layout, picture.size());
    if (!held || held->size != size || row < 0 || row >= held->rows) {
        const auto [width, height] = picture_size(layout, size);
        throw Error("the layout '" + std::string(layout.name) + "' of size " +
                    std::to_string(size) + " is " + std::to_string(width) + "x" +
                    std::to_string(height) + "; this picture is " + std::to_string(picture.width) +
                    "x" + std::to_string(picture.height));
    }
    const int height = picture.height / held->rows;
    Lut3D cube = identity_cube(size);
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                const Pixel p = layout.pixel(size, picture.width, r, g, b);
                cube.at(r, g, b) = picture.at(p.x, p.y + row * height);
            }
        }
    }
    return cube;
}

} // namespace lutlib
