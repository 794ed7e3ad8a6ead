// Shadows by rays, in double: what shadow maps stand for.
#pragma once

#include "preview/scene/scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace preview::reference {

/// The triangles of the objects that cast shadows, in the world.
class Casters {
  public:
    explicit Casters(const Scene& scene);
    /// Whether a triangle stands between the points, other than within `least` of `from`, in
    /// metres.
    bool block(glm::dvec3 from, glm::dvec3 to, double least = 1e-6) const;

  private:
    std::vector<std::array<glm::dvec3, 3>> triangles_;
};

} // namespace preview::reference
