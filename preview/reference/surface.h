// A surface at a point of it, in double. Twin of shaders/common/detail_surface.glsl.
#pragma once

#include "preview/reference/texture.h"

#include <glm/vec3.hpp>

namespace preview::reference {

struct SurfacePoint {
    glm::dvec2 uv[2]{}, dx[2]{}, dy[2]{}; ///< and their changes to the pixels beside
    glm::dvec4 color{1};
    glm::dvec3 normal{0, 0, 1};
    glm::dvec4 tangent{0}; ///< unit and across the normal; w: its side, 0 where there is none
};

struct DetailedSurface {
    glm::dvec3 albedo{0}, emission{0}, normal{0};
    double roughness = 0, metalness = 0, occlusion = 1;
    bool is_cut_out = false;
};

DetailedSurface surface_of(const Scene& scene, const Material& material, const SurfacePoint& at);

} // namespace preview::reference
