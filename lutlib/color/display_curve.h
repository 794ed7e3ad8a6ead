// Which codes are a display's and which stand for a scene's light.
#pragma once

#include "lutlib/color/transfer_curve.h"

namespace lutlib {

/// Whether codes of this curve are what a display shows, where 1 is its white. All others, linear
/// light among them, stand for a scene's light, which goes on above white.
bool is_display_curve(const TransferCurve& curve);

} // namespace lutlib
