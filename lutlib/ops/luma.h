// ASC CDL's saturation about Rec.709 luma.
#pragma once

#include "lutlib/color/luma.h"

namespace lutlib::op {

/// ASC CDL 1.2: luma + s (x - luma), written so that s = 1 gives x exactly.
inline RgbD scale_saturation(RgbD c, double s) {
    const double y = luma(c);
    return c * s + RgbD{y, y, y} * (1 - s);
}

} // namespace lutlib::op
