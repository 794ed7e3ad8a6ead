// Parts of extremes(): what a scene or picture itself may be.
#pragma once

#include "preview/check/situation.h"

#include <vector>

namespace preview {

/// Texels that are not finite, or at an end of what floats hold.
void add_pictures(std::vector<Extreme>& rows);
/// Geometry and materials at an end of what they may be.
void add_scenes(std::vector<Extreme>& rows);

} // namespace preview
