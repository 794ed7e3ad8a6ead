// Where the node (r,g,b) of a lattice sits in a picture, for every layout in use.
//
// N is the lattice size; r,g,b run over 0..N-1; x to the right and y down from the top row.
#pragma once

#include "lutlib/code_image.h"
#include "lutlib/lut.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

struct PictureSize {
    int width = 0, height = 0;
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

struct Layout {
    std::string_view name;
    std::string_view help;
    std::string_view sizes; ///< in words, which sizes it has pictures for
    bool stacks;            ///< several lattices may lie below each other in one picture
    /// The picture that a lattice of size n gets; nullopt where the layout has none for that size.
    std::optional<PictureSize> (*picture)(int n);
    /// The size of the one lattice that a picture of these dimensions holds, whether picture()
    /// would choose them or not; nullopt where the layout has no such picture.
    std::optional<int> (*lattice)(PictureSize picture);
    /// `width` is the picture's, which tells how many tiles lie side by side.
    Pixel (*pixel)(int n, int width, int r, int g, int b);
};

/// strip, strip-up, strip-vertical, ocio, hald, tiles.
std::span<const Layout> layouts();
const Layout* layout_named(std::string_view name);

/// A picture of RGB code values (1 is the largest code), rows from the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<Rgb> pixels;

    PictureSize size() const { return {width, height}; }
    const Rgb& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    Rgb& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// How a picture holds lattices in a layout: their size, and how many lie below each other.
struct Arrangement {
    int size = 0, rows = 1;
};
/// nullopt where the layout has no picture of these dimensions.
std::optional<Arrangement> arrangement_in(const Layout& layout, PictureSize picture);

/// Lattice to picture and back. Both throw Error when the size does not fit the layout. `row` picks
/// one of several lattices stacked below each other (ReShade's multi-LUT files), from the top and
/// 0; below the last throws Error.
Picture to_picture(const Lut3D& cube, const Layout& layout);
Lut3D from_picture(const Picture& picture, const Layout& layout, int size, int row = 0);

} // namespace lutlib
