// A control for a parameter that is no curve, as its descriptor tells: of operators and of effects.
#pragma once

#include "preview/panels/ui.h"

#include <string>

namespace preview::panels {

/// The default in words, with its unit; of a curve the neutral one.
std::string usual_text(const lutlib::Parameter& parameter, const lutlib::OpContext& context = {});

/// True when the value changed; nothing is drawn of a curve. `place` is the control's name for
/// mark().
bool parameter_control(Ui& ui, const lutlib::Parameter& parameter, lutlib::Value& value,
                       const std::string& place, const lutlib::OpContext& context = {});

} // namespace preview::panels
