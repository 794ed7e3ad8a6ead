// The noise of the background in double; twin of shaders/common/noise.glsl.
#pragma once

#include "lutlib/rgb.h"
#include "preview/scene/surroundings.h"

#include <glm/vec3.hpp>

namespace preview::reference {

/// Perlin 2002, "Improving noise": within -1..1, with a period of 256.
double perlin(glm::dvec3 p);

/// Linear light from a unit direction; `noise` as noise_now() gives it.
lutlib::RgbD noise_background(glm::dvec4 noise, glm::dvec3 direction);

} // namespace preview::reference
