// What of a look's results a display shows.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/rgb.h"

#include <vector>

namespace lutlib {

/// Whether displays take codes of this encoding: then nothing outside 0..1 is ever seen. Linear
/// light and cameras' curves are on their way to one.
bool is_for_displays(const Encoding& encoding);

/// Of results, what lies outside 0..1.
struct OutsideDisplay {
    double share = 0; ///< of the colours, with a channel outside
    double most = 0;  ///< the furthest channel's distance from 0..1
};
OutsideDisplay outside_display(const std::vector<RgbD>& results);

} // namespace lutlib
