// What a control says while the mouse is over it.
#pragma once

#include <string>
#include <string_view>

namespace preview::panels {

/// Of the last item: what it is, and how it usually is, with its unit; both may be empty. A number
/// can be typed.
void tip(std::string_view help, const std::string& usual, bool is_number = true);

/// Of a control that is switched off because it changes nothing, and why.
void idle_tip(std::string_view why);

} // namespace preview::panels
