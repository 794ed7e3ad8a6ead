// A control for a parameter, as its descriptor tells: of operators and of effects.
#pragma once

#include "preview/panels/ui.h"

#include <string>

namespace preview::panels {

/// True when the value changed. `place` is the control's name for mark().
bool parameter_control(Ui& ui, const lutlib::Parameter& parameter, lutlib::Value& value,
                       const std::string& place, const lutlib::OpContext& context = {});

} // namespace preview::panels
