// Ambient occlusion in double: the passes of preview/passes/occlusion.h formula for formula, and by
// rays what they stand for.
#pragma once

#include "preview/scene/scene_data.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace preview::reference {

/// What a g-buffer shows, rows from the top.
struct SeenSurfaces {
    ViewBlock view;
    int width = 0, height = 0;
    std::vector<float> depth; ///< 0 near to 1 at infinity; 1 where there is nothing
    std::vector<glm::dvec3> normal;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    bool shows(int x, int y) const;
    /// Relative to the camera.
    glm::dvec3 position(int x, int y) const;
};

/// The direction whose octahedral coordinates are two words of a g-buffer's normal, 0..65534.
glm::dvec3 octahedral_normal(double x, double y);

struct OcclusionModel {
    double strength = 1, radius = 0.3;
    int samples = 16;
    int cell = 2; ///< its side, in pixels
};

/// What is left of the light from the surroundings at each pixel.
std::vector<double> occlusion(const SeenSurfaces& seen, const OcclusionModel& model);

/// The same before it is made for one pixel of a cell, blurred and enlarged: of each pixel by
/// itself, without offsets that differ from pixel to pixel.
std::vector<double> occlusion_of_every_pixel(const SeenSurfaces& seen, const OcclusionModel& model);

/// By rays in cosine-weighted directions: a hit at distance d < radius hides 1 - sqrt(d / radius),
/// which is what points at radius u^2 along the ray come to. `hit` gives the distance along a unit
/// direction.
double
ray_cast_occlusion(glm::dvec3 normal, double radius, int rays,
                   const std::function<std::optional<double>(const glm::dvec3& direction)>& hit);

} // namespace preview::reference
