// Balls, rods and rings by what shaders/common/area_light.glsl makes of them, in double: the exact
// irradiance of lines, and a point that stands for the light in the highlight. area_light.h has the
// integrals that this stands for.
#pragma once

#include "preview/reference/ggx.h"
#include "preview/scene/scene.h"

#include <glm/vec3.hpp>

namespace preview::reference {

struct AreaLight {
    PointLight::Shape shape = PointLight::Shape::point; ///< a ball
    glm::dvec3 centre{0};                               ///< relative to the surface
    glm::dvec3 extent{0};                               ///< PointLight::extent
    double thickness = 0;
};

/// Irradiance per unit of intensity under the line from `a` to `b`, relative to the surface.
double line_irradiance(glm::dvec3 normal, glm::dvec3 a, glm::dvec3 b);

/// Radiance towards unit `view` per unit of the light's intensity.
lutlib::RgbD shade(const Surface& surface, glm::dvec3 view, const AreaLight& light);

} // namespace preview::reference
