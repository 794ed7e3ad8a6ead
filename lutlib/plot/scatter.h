// Scatter plots on logarithmic axes as SVG, for pages that must work without scripts and on paper.
#pragma once

#include "lutlib/plot/axis.h"

#include <cstddef>
#include <string>
#include <vector>

namespace plot {

/// Marks of one kind share a colour and a name in the legend.
struct Series {
    std::string name;
};

struct Mark {
    double x = 0, y = 0;
    double x_low = 0, x_high = 0; ///< the interval of x, drawn where it is wide enough to be seen
    std::size_t series = 0;
    bool diamond = false;  ///< else a circle
    bool on_front = false; ///< joined by the front's line
    bool recommended = false;
    bool pale = false;
    std::string label = {}; ///< shown on hover; empty: the page's script tells what the row is
    std::string name = {};  ///< short: written beside it where it is a knee of the front
    std::size_t row = 0;    ///< of the page's table, to which a click leads
};

struct Scatter {
    std::string title;
    std::string x_label, y_label;
    std::string circle_name, diamond_name; ///< for the legend; empty: not in it
    std::vector<Series> series;
    std::vector<Mark> marks;
    double y_floor = 0; ///< the axis starts no lower
};

/// An <svg> element. A value that a logarithmic axis cannot show (0, or not finite) is drawn at the
/// edge of the plot, and its label says so. A mark that would hide another stands beside it, by 40
/// pixels at most; what is not pale keeps its place first. The knees of the front, up to eight, are
/// those that dominate most of the plot alone.
std::string svg(const Scatter& scatter);

} // namespace plot
