// Scatter plots on logarithmic axes as SVG, for pages that must work without scripts and on paper.
#pragma once

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
    std::size_t series = 0;
    bool diamond = false;  ///< else a circle
    bool on_front = false; ///< joined by the front's line
    bool recommended = false;
    bool pale = false;
    std::string label;   ///< shown on hover
    std::size_t row = 0; ///< of the page's table, to which a click leads
};

struct Scatter {
    std::string title;
    std::string x_label, y_label;
    std::string circle_name, diamond_name; ///< for the legend; empty: not in it
    std::vector<Series> series;
    std::vector<Mark> marks;
    double y_floor = 0;    ///< the axis starts no lower
    double series_gap = 0; ///< pixels between series of equal x, which would hide each other
};

/// An <svg> element. A value that a logarithmic axis cannot show (0, or not finite) is drawn at the
/// edge of the plot, and its label says so.
std::string svg(const Scatter& scatter);

/// Text as HTML and XML want it.
std::string escaped(const std::string& text);

} // namespace plot
