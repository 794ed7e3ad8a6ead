// Colours of six hues, from dark to light, before and after a look.
#pragma once

#include "converter/panels/panel.h"

#include <functional>

namespace converter {

/// One hue's colours at rising luminance, half way in light from grey to the input encoding's
/// primary or secondary, as far as their codes lie within the domain.
struct Sweep {
    std::size_t hue = 0;                     ///< of hue_rows
    std::vector<double> stops;               ///< of the input's luminance, about 18 % of white
    std::vector<lutlib::RgbD> before, after; ///< linear Rec.709 light
};

std::vector<Sweep> sweeps_of(const ShownLook& look);

/// A figure of a value that colours have, after a look and (thin) before it, against the luminance
/// of the input. `value` gets the colour and what it was before.
plot::Figure sweep_figure(ShownLooks looks,
                          const std::function<double(lutlib::RgbD, lutlib::RgbD)>& value);

} // namespace converter
