// The lighting pass in double: what leaves a surface for the eye under lights with their shadows,
// surroundings and its own light, and what is seen where there is none.
#pragma once

#include "preview/reference/shadow_map.h"
#include "preview/reference/surroundings_map.h"
#include "preview/scene/environment.h"

#include <span>

namespace preview::reference {

struct LitSurface {
    Surface material; ///< with the shading's normal
    lutlib::RgbD emission{};
    double occlusion = 1;   ///< that its own texture leaves of the surroundings
    bool is_unlit = false;  ///< it only gives its own light
    glm::dvec3 position{0}; ///< in the world
    glm::dvec3 face{0};     ///< unit, of the geometry
    /// Which of its sides that looks to hangs on roundings.
    bool is_face_in_doubt = false;
    glm::dvec3 view{0};    ///< unit, to the eye
    double unoccluded = 1; ///< what ambient occlusion leaves of the surroundings
};

/// What shines on surfaces.
struct Illumination {
    std::span<const LightBlock> lights;
    ShadowMaps shadow_maps;
    const ShadowFilter* shadow_filter = nullptr;
    bool has_occlusion = false; ///< then highlights of the surroundings fade where they are hidden
    /// One of both, or neither.
    const Environment* environment = nullptr;
    const SurroundingsMaps* maps = nullptr;
};

/// Light, the sum of its parts' magnitudes, and how far roundings of floats and of a texture unit's
/// weights may move it.
struct Lit {
    lutlib::RgbD light, magnitude, doubt;
};

/// `rounding`: by how many metres floats may place the surface elsewhere. Where a light is so near,
/// or so near the surface's horizon, that this matters, it is part of the doubt.
Lit lit(const LitSurface& surface, const Illumination& by, double rounding);

} // namespace preview::reference
