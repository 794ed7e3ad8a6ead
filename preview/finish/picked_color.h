// What there is to tell of a colour of an sRGB display.
#pragma once

#include "lutlib/color/difference.h"
#include "lutlib/rgb.h"
#include "preview/finish/probe.h"

#include <string>
#include <vector>

namespace preview {

struct ColorFigures {
    Codes codes{};
    lutlib::RgbD linear{}; ///< light by sRGB's curve, 1 is the display's white
    double luminance = 0;  ///< of a display with that white, in cd/m2
    lutlib::Lab lab{};     ///< CIELAB about D65
};
/// Of a colour's codes over 0..1, which are clamped to them; `white` in cd/m2.
ColorFigures figures_of(lutlib::RgbD color, double white);

/// A place of the picture whose colour a person has kept.
struct PickedColor {
    ProbePlace place{};
    Probe probe{};
};
inline constexpr std::size_t most_picked_colors = 16;
/// Puts it before the others; the oldest go.
void pick(std::vector<PickedColor>& picked, const PickedColor& color);

/// "120 96 80", "0.1878 0.1170 0.0802", "12.9 cd/m2", "L* 42.1 a* 8.3 b* 11.9".
std::string codes_text(const ColorFigures& figures);
std::string linear_text(const ColorFigures& figures);
std::string luminance_text(const ColorFigures& figures);
std::string lab_text(const ColorFigures& figures);

} // namespace preview
