// A figure on linear axes: lines, rectangles of colours, dots and words, in the values that they
// stand for. What it looks like is the affair of drawing_of().
#pragma once

#include "lutlib/plot/drawing.h"
#include "lutlib/plot/lines.h"
#include "lutlib/plot/value_axis.h"
#include "lutlib/rgb.h"

#include <string>
#include <vector>

namespace plot {

struct Tick {
    double at = 0;
    std::string text;
};

struct Scale {
    std::string label;
    Extent range = {};            ///< widened to hold what is shown
    std::vector<Tick> ticks = {}; ///< in place of round numbers
};

/// Colours side by side over a rectangle of the axes.
struct Cells {
    std::string name;
    double left = 0, right = 1, bottom = 0, top = 1;
    int columns = 0, rows = 0;
    /// sRGB codes, the lowest row first; one that is not finite is not drawn, others are held to
    /// 0..1.
    std::vector<lutlib::RgbD> colors;
    std::vector<std::string> labels = {}; ///< of the columns, shown on hover; empty: none
};

struct Dot {
    double x = 0, y = 0;
    lutlib::RgbD color; ///< sRGB codes
};

/// Dots of one kind, what is further away first.
struct Dots {
    std::string name;
    std::vector<Dot> dots;
};

/// Text in the middle of a place.
struct Note {
    double x = 0, y = 0;
    std::string text;
};

struct Figure {
    std::string title;
    Scale x, y;
    bool same_units = false; ///< a unit is as long upwards as to the right
    bool has_axes = true;    ///< else neither lines nor numbers of them are drawn
    bool is_wide = false;    ///< takes the whole width of a sheet
    std::vector<Cells> cells = {};
    std::vector<Line> lines = {}; ///< points that are not finite interrupt a line
    std::vector<Dots> dots = {};
    std::vector<Note> notes = {};
};

/// The usual size of a figure, in dots.
inline constexpr double figure_width = 304, figure_height = 228;
/// Of one that is wide, on a page.
inline constexpr double wide_figure_width = 920, wide_figure_height = 130;

/// `height` at most: rectangles of colours in same units take no more than they need.
Drawing drawing_of(const Figure& figure, double width = figure_width,
                   double height = figure_height);

} // namespace plot
