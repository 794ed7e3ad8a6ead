// Small pictures made of cells, as SVG that a script can colour anew: heat maps of values and rows
// of colours. A cell's level is one character, so that the maps of many rows fit into a page.
#pragma once

#include <cstddef>
#include <string>

namespace plot {

/// The character of a level of 0..63; 64 and more as 63.
char level_letter(std::size_t level);
/// A cell that has no value.
inline constexpr char no_level = '.';
/// Of all levels, in order.
std::string level_letters();

/// The level of an error, logarithmic from `heat_low` to `heat_high`; NaN: no_level.
inline constexpr double heat_low = 0.01, heat_high = 30;
char error_letter(double error);
/// The level of 0..1, linear; values beyond are held to it.
char share_letter(double share);

struct HeatMap {
    std::string id; ///< of the element, for scripts
    std::string title;
    std::string x_label, y_label;
    int columns = 0, rows = 0;
    std::string levels;  ///< columns * rows letters, the first row at the bottom
    int lines_every = 0; ///< columns and rows between lines across the map; 0: none
};
std::string svg(const HeatMap& map);

/// Colours side by side: three letters of share_letter() a column, red, green and blue.
struct Band {
    std::string id, label;
    std::string levels;
};
std::string svg(const Band& band);

/// What colour stands for what error.
std::string heat_legend(const std::string& metric);

} // namespace plot
