// Linear axes of plots.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace plot {

/// From place `start` to place `end` of a drawing; `low` lies below `high`, both finite.
struct ValueAxis {
    double low, high;
    double start, end;

    /// The place of a value: of one beyond an end that end, of NaN the start.
    double at(double value) const;
    /// Whether a value lies between the ends.
    bool shows(double value) const { return value >= low && value <= high; }
};

/// A range of values; empty while `low` lies above `high`.
struct Extent {
    double low = 1, high = -1;

    bool is_empty() const { return !(low <= high); }
    /// Widened to hold a value; one that is not finite changes nothing.
    void add(double value);
    void add(std::span<const double> values);
    /// Wide enough for an axis: what is empty becomes 0..1, what is one value gets room on both
    /// sides, and ends lie so far within the range of a double that margins have room.
    Extent with_width() const;
};

/// Multiples of 1, 2 or 5 times a power of ten between the ends, at most `most` of them.
std::vector<double> round_values(const Extent& range, int most);
/// At most four significant digits; what is nothing beside the range is 0.
std::string value_text(double value, const Extent& range);

} // namespace plot
