// The gradient and soft boxes of preview/scene/environment.h in double, which has their sources.
#pragma once

#include "lutlib/rgb.h"
#include "preview/scene/environment.h"

#include <glm/vec3.hpp>

namespace preview::reference {

/// From unit `direction`, blurred by the lobe of perceptual `roughness`.
lutlib::RgbD radiance(const Environment& environment, glm::dvec3 direction, double roughness);

/// Of a surface with unit `normal`.
lutlib::RgbD irradiance(const Environment& environment, glm::dvec3 normal);

} // namespace preview::reference
