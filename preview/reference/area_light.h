// Balls, rods and rings that shine, by brute force in double: what shaders/common/area_light.glsl
// stands for.
#pragma once

#include "preview/reference/ggx.h"
#include "preview/scene/scene.h"

namespace preview::reference {

/// A unit vector across a unit `axis`; where a ring about it begins.
glm::dvec3 across(glm::dvec3 axis);

/// Radiance of a surface at `position` towards unit `view` under the light alone and without its
/// shadow: the mean over `points` points along its middle line, or evenly over the ball as it
/// is seen.
lutlib::RgbD shade_area(const PointLight& light, const Surface& surface, glm::dvec3 position,
                        glm::dvec3 view, int points);

} // namespace preview::reference
