// Changes of lights as text: NAME.CONTROL=VALUE, or three values with commas between them.
#pragma once

#include "preview/scene/light_controls.h"

#include <string>
#include <vector>

namespace preview {

/// What a text has changed: which light, and what of it.
struct LightEdit {
    std::size_t light = 0;
    const LightControl* control = nullptr;
};

/// Changes the light of that name or number by a row of light_controls(). Throws lutlib::UsageError
/// for what no light or control is, and for values that are no number or out of range.
LightEdit edit_light(std::vector<PointLight>& lights, const std::string& text);

} // namespace preview
