// The settings of the cube view as rows, which flags and the panel are made from.
#pragma once

#include "preview/finish/setting_rows.h"
#include "preview/look/cube_view.h"

#include <span>

namespace preview {

std::span<const NumberRow<CubeView>> cube_numbers();
std::span<const SwitchRow<CubeView>> cube_switches();

} // namespace preview
