// Logarithmic axes of plots.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace plot {

/// From pixel `start` to pixel `end`.
struct Axis {
    double low, high; ///< powers of ten
    double start, end;

    /// The pixel of a value; of 0 and less the start, of NaN the end.
    double at(double value) const;
    /// Whether a value has a place between the ends.
    bool shows(double value) const;
};

/// Holds every value that is above 0 and finite, with a margin.
Axis axis_over(const std::vector<double>& values, double start, double end);

/// Every decade; 2 and 5 as well where there are few.
std::vector<double> ticks(const Axis& axis);
/// Powers of ten beyond what is read at a glance are written as such: markup of a <text>.
std::string tick_text(double value);

/// What a plot stands in: its lines, its numbers and what they are of.
struct Frame {
    std::string title, x_label, y_label;
    double left, right, top, bottom; ///< pixels
};
std::string svg(const Frame& frame, const Axis& x, const Axis& y);

/// Text as HTML and XML want it.
std::string escaped(const std::string& text);

} // namespace plot
