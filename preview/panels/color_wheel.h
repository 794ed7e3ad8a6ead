// A colour wheel with a ring for brightness and numbers that can be typed, of any rgb parameter
// that has a Wheel.
#pragma once

#include "preview/panels/ui.h"

#include <span>
#include <string>

namespace preview::panels {

/// True when the value changed. Dragging moves from where the value is, a tenth as far with Shift;
/// a double click brings the wheel's part or the ring's back to the default. `place` is its name
/// for mark(): the wheel itself, and .r .g .b .y for the numbers.
bool color_wheel(Ui& ui, const lutlib::Parameter& parameter, lutlib::RgbD& value,
                 const std::string& place, float width);

/// Those of the parameters that have a wheel, beside each other as far as there is room, each by
/// its name behind `place`.
bool color_wheels(Ui& ui, std::span<const lutlib::Parameter> parameters,
                  std::span<lutlib::Value> values, const std::string& place);

} // namespace preview::panels
