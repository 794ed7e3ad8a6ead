// Shadows by maps, in double: what the filter of shaders/common/shadow.glsl finds in given maps.
// shadow.h has what maps stand for.
#pragma once

#include "preview/finish/light_filters.h"
#include "preview/scene/scene_data.h"

#include <glm/vec3.hpp>

#include <span>

namespace preview::reference {

struct ShadowMaps {
    int side = 0;                  ///< texels
    std::span<const float> depths; ///< rows from the top, layers one behind the other
};

/// What of a light arrives.
struct Arrival {
    double share = 1; ///< 0..1; 1 beyond the maps
    double doubt = 0; ///< of it; what comparisons say that hang on roundings of floats
};

/// Every texel of the filter compares its depth with that of the surface's own plane there, whose
/// geometry has the unit normal `face`. The light has maps.
Arrival arrival(const ShadowMaps& maps, const LightBlock& light, const ShadowFilter& filter,
                glm::dvec3 position, glm::dvec3 face);

} // namespace preview::reference
