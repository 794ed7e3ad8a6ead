// Rec.709 luma: the weights of BT.709-6, item 3.2, on code values as they are.
#pragma once

#include "lutlib/rgb.h"

namespace lutlib {

constexpr double luma(RgbD c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

} // namespace lutlib
