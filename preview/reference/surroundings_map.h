// What a surface takes of a sky or a picture of all directions from the maps that are made of them,
// in double: shaders/common/surroundings.glsl on given maps. surroundings.h has what maps stand
// for.
#pragma once

#include "preview/reference/ggx.h"
#include "preview/reference/image.h"
#include "preview/scene/sky.h"

#include <array>
#include <functional>

namespace preview::reference {

/// Light, and how far an 8-bit weight of a texture unit may move it.
struct Filtered {
    lutlib::RgbD light, doubt;
};

struct SurroundingsMaps {
    double turn = 0; ///< of a picture to the right, radians
    double factor = 1;
    int level_count = 1;
    Image levels;      ///< as surfaces of rising roughness mirror it, stacked
    Image reflectance; ///< scale and bias of f0; n.v goes along x, roughness along y
    std::array<lutlib::RgbD, 9> harmonics{}; ///< of the irradiance
    /// What a mirror sees, in the turned direction.
    std::function<Filtered(glm::dvec3 direction)> mirror;
};

/// A picture turned to the right shows in a direction what it has in this one.
glm::dvec3 turned(const SurroundingsMaps& maps, glm::dvec3 direction);

/// Of the pictures of all directions in `all`, one below the other and of that height, number
/// `level`: bilinear, round about, and nothing of those beside it.
Filtered sphere_sample(const Image& all, glm::dvec3 direction, int level, int height);

/// What `surface` reflects, of which `seen` of the diffuse and `seen_mirrored` of the mirrored
/// surroundings are not hidden. Fdez-Aguera 2019, "A multiple-scattering microfacet model for
/// real-time image-based lighting".
Filtered reflected(const SurroundingsMaps& maps, const Surface& surface, glm::dvec3 view,
                   double seen, double seen_mirrored);

} // namespace preview::reference
