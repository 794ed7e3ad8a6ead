// The camera's numbers as rows, which flags, sliders and --explain are made from. A flag is added
// to the scene's own number.
#pragma once

#include "preview/finish/setting_rows.h"
#include "preview/scene/camera.h"

#include <span>

namespace preview {

std::span<const NumberRow<Orbit>> camera_numbers();

} // namespace preview
