// What figures are made of, drawn as SVG or as pixels. Places and lengths are in dots of the font
// (dot_font.h), from the upper left corner, so that text takes the same room in both.
#pragma once

#include "lutlib/plot/raster.h"

#include <string>
#include <variant>
#include <vector>

namespace plot {

struct Point {
    double x = 0, y = 0;
};

/// A line through points. One that is not finite interrupts it.
struct Stroke {
    std::vector<Point> points;
    Rgb8 color{};
    double width = 1;
    bool dashed = false;
    std::string label = {}; ///< shown on hover, where something can be
};

struct Disc {
    Point center;
    double radius = 1;
    Rgb8 color{};
};

/// A filled rectangle; its edges lie on whole pixels, so that neighbours meet without a seam.
struct Box {
    Point corner, opposite; ///< the upper left one, the lower right one
    Rgb8 color{};
    std::string label = {}; ///< shown on hover, where something can be
};

enum class Anchor { start, middle, end };

/// A line of UTF-8 text without control characters.
struct Words {
    Point at; ///< of its upper left corner, or the middle or right end of its upper edge
    std::string text;
    Anchor anchor = Anchor::start;
    Rgb8 color{};
    std::size_t most = 1000; ///< characters; of a longer text the middle is left out
    bool bold = false;       ///< where there are such letters
};

using Shape = std::variant<Stroke, Disc, Box, Words>;

struct Drawing {
    double width = 0, height = 0;
    std::string label; ///< for those who do not see it
    std::vector<Shape> shapes;

    /// Another drawing with its upper left corner at a place of this one.
    void add(const Drawing& part, Point at);
};

inline constexpr Rgb8 drawing_ground{255, 255, 255};

/// An <svg> element. Where `width` is given it is a file of its own, of so many pixels.
std::string svg(const Drawing& drawing, int width = 0);

/// `width` pixels wide, and as high as that makes it. A dot of text is a square of as many pixels
/// as a dot of the drawing holds, but at least one.
Raster raster(const Drawing& drawing, int width);
/// The height of that.
int raster_height(const Drawing& drawing, int width);

} // namespace plot
