// Where an rgb parameter's value stands on a colour wheel with a ring for its brightness.
//
// A value's change from its default is split by BT.709's matrix into luma and the colour
// differences Cb and Cr, which a vectorscope shows: where a wheel's handle is pulled to, the
// picture goes on the vectorscope. The wheel moves colour differences at the same luma, the ring
// luma at the same differences.
#pragma once

#include "lutlib/ops/op.h"

namespace preview::editor {

struct WheelPlace {
    double x = 0, y = 0; ///< Cb to the right and Cr upwards; the rim is at 1 from the middle
    double turn = 0;     ///< of the ring: 0 the default, -1 and 1 its ends; may be beyond
};

/// `parameter` has a wheel.
WheelPlace wheel_place(const lutlib::Parameter& parameter, lutlib::RgbD value);

/// The value there, within the parameter's range: luma is held in it, then colour differences are
/// made smaller together until every channel is.
lutlib::RgbD value_on_wheel(const lutlib::Parameter& parameter, const WheelPlace& place);

/// The colour of a direction on the wheel, as codes 0..1 about a middle grey. `angle` in radians,
/// from the right towards the top.
lutlib::RgbD wheel_color(double angle);

} // namespace preview::editor
