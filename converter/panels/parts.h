// What panels share: colours as they are seen, and lines and names of looks.
#pragma once

#include "converter/panels/panel.h"
#include "lutlib/color/matrix.h"

#include <cstddef>
#include <limits>

namespace converter {

inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Code values as the light that they stand for, and back.
class SeenLight {
  public:
    explicit SeenLight(const lutlib::Encoding& encoding);

    /// Linear Rec.709 light, without bounds, of which 1 is diffuse white. Codes that displays take
    /// are held to 0..1, as displays do. What is not finite has no_value.
    lutlib::RgbD of(lutlib::RgbD codes) const;
    lutlib::RgbD codes(lutlib::RgbD rec709) const;

  private:
    lutlib::Encoding encoding_;
    lutlib::Matrix3 to_rec709_, from_rec709_;
};

/// Of linear Rec.709 light.
lutlib::RgbD xyz_of_light(lutlib::RgbD rec709);
/// The sRGB codes that show it, without bounds.
lutlib::RgbD srgb_of_light(lutlib::RgbD rec709);

/// Images of colours through a look, on all cores.
std::vector<lutlib::RgbD> images_of(const ShownLook& look, std::vector<lutlib::RgbD> codes);

/// The same inputs are meant for both: "before" is the same then.
bool same_inputs(const ShownLook& a, const ShownLook& b);
/// The looks whose inputs are shown as "before": the first, and the second where its are others.
std::vector<const ShownLook*> befores(ShownLooks looks);
/// "before", or whose before where there are several.
std::string before_name(ShownLooks looks, const ShownLook& look);

/// A line of look `i` that is of `what`, which the colour tells; the second look's are dashed and
/// pale. The legend has the first look's for both, and needs key_of().
plot::Line line_of(ShownLooks looks, std::size_t i, const std::string& what, std::size_t color);
/// What tells two looks' lines apart, for a legend: lines without points. None of one look.
std::vector<plot::Line> key_of(ShownLooks looks);
/// A line that is the look's alone, in its own colour.
plot::Line line_of(ShownLooks looks, std::size_t i);
/// What the looks are held against: thin and grey.
plot::Line thin_line(const std::string& name);

/// Colours of lines: the places of red, green and blue, and of what is none of them, in the
/// palette.
inline constexpr std::size_t series_of_channel[3]{1, 3, 2};
inline constexpr std::size_t series_of_all = 7;
inline constexpr const char* channel_names[3]{"red", "green", "blue"};

/// Of six hues about the dial from red: their names and places in the palette.
struct HueRow {
    const char* name;
    lutlib::RgbD rgb;
    std::size_t series;
};
inline constexpr HueRow hue_rows[6]{{"red", {1, 0, 0}, 1},   {"yellow", {1, 1, 0}, 5},
                                    {"green", {0, 1, 0}, 3}, {"cyan", {0, 1, 1}, 6},
                                    {"blue", {0, 0, 1}, 2},  {"magenta", {1, 0, 1}, 4}};

/// From `low` to `high`, both included.
std::vector<double> evenly(double low, double high, int count);

} // namespace converter
