// Curves on a logarithmic x axis as SVG: y logarithmic too, or a share of 0..1.
#pragma once

#include "lutlib/plot/axis.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace plot {

struct Line {
    std::string name;      ///< in the legend; empty: not in it
    std::string label;     ///< shown on hover
    std::size_t color = 0; ///< of series_colours
    bool dashed = false;
    bool dots = true; ///< a dot at each point
    std::vector<std::pair<double, double>> points;
    bool pale = false; ///< half way to white
};

struct Lines {
    std::string title, x_label, y_label;
    std::vector<Line> lines;
    bool y_is_share = false; ///< from 0 to 1, evenly
    double y_floor = 0;      ///< a logarithmic y axis starts no lower
    /// Of the axis; where they are equal, what the points need.
    double x_low = 0, x_high = 0;
    double width = 560, height = 420;
    std::string first_line_id; ///< the first line's element's id, for scripts; empty: none
};

/// An <svg> element. Points that a logarithmic axis cannot show are left out.
std::string svg(const Lines& lines);

/// The "d" of a line of shares in a plot whose ends are given.
std::string share_path(const Lines& lines, const std::vector<std::pair<double, double>>& points);

} // namespace plot
