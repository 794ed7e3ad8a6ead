// Rec.709 luma, the weights that ASC CDL's saturation uses on code values.
#pragma once

#include "lutlib/rgb.h"

namespace lutlib::op {

/// ASC CDL 1.2: luma + s (x - luma), written so that s = 1 gives x exactly.
inline RgbD scale_saturation(RgbD c, double s) {
    const double luma = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    return c * s + RgbD{luma, luma, luma} * (1 - s);
}

} // namespace lutlib::op
