// The rows of the table in panels.cpp.
#pragma once

#include "converter/panels/panel.h"

namespace converter::panel {

extern const Panel curves;
extern const Panel slopes;
extern const Panel hue;
extern const Panel saturation;
extern const Panel hull_ucs;
extern const Panel hull_oklab;
extern const Panel slices;
extern const Panel cube;
extern const Panel gradient;
extern const Panel skin;

} // namespace converter::panel
