// Lines and discs with smooth edges on a raster. Places are in pixels: the middle of the upper left
// one is (0.5, 0.5). What lies outside of the picture is not drawn.
#pragma once

#include "lutlib/plot/drawing.h"
#include "lutlib/plot/raster.h"

#include <span>
#include <vector>

namespace plot {

/// How much of a pixel is covered is taken for how far its middle lies within the edge, from 0 half
/// a pixel outside to 1 half a pixel inside. A line that crosses itself covers no more for it.
void draw_line(Raster& raster, std::span<const Point> points, double width, Rgb8 color);
void draw_disc(Raster& raster, Point center, double radius, Rgb8 color);

/// The pieces of a line between places that are not finite, and of each what is drawn where `on`
/// pixels are and `off` are not in turn.
std::vector<std::vector<Point>> pieces_of(std::span<const Point> points);
std::vector<std::vector<Point>> dashes_of(std::span<const Point> points, double on, double off);

} // namespace plot
