// White balance from a colour of a picture that should be neutral.
#pragma once

#include "lutlib/color/primaries.h"
#include "lutlib/rgb.h"

#include <optional>

namespace lutlib::op {

/// Values of the operator white-balance's parameters, in their order and units.
struct WhiteBalance {
    double kelvin = 0, tint = 0;
};

/// The one that makes linear light on these primaries neutral. Where no light in the parameters'
/// ranges has its chromaticity, the one of the nearest that has. None for light without a
/// chromaticity of positive X, Y and Z.
std::optional<WhiteBalance> white_balance_of(RgbD light, const Primaries& primaries);

} // namespace lutlib::op
