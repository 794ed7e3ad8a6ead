#include "preview/reference/area_light.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

glm::dvec3 across(glm::dvec3 axis) {
    return glm::normalize(
        glm::cross(axis, std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

namespace {

glm::dvec3 point_of(const PointLight& light, glm::dvec3 from, double share, int number) {
    const glm::dvec3 centre(light.position), extent(light.extent);
    if (light.shape == PointLight::Shape::point) { // a disc, in a spiral
        const glm::dvec3 axis = glm::normalize(centre - from), x = across(axis);
        const double angle = 2.399963229728653 * number; // the golden angle
        return centre + static_cast<double>(light.thickness) * std::sqrt(share) *
                            (std::cos(angle) * x + std::sin(angle) * glm::cross(axis, x));
    }
    if (light.shape == PointLight::Shape::rod) {
        return centre + (2 * share - 1) * extent;
    }
    const double radius = glm::length(extent), angle = 2 * std::numbers::pi * share;
    const glm::dvec3 axis = extent / radius;
    const glm::dvec3 x = across(axis);
    return centre + radius * (std::cos(angle) * x + std::sin(angle) * glm::cross(axis, x));
}

} // namespace

lutlib::RgbD shade_area(const PointLight& light, const Surface& surface, glm::dvec3 position,
                        glm::dvec3 view, int points) {
    lutlib::RgbD sum;
    for (int i = 0; i < points; ++i) {
        const glm::dvec3 towards = point_of(light, position, (i + 0.5) / points, i) - position;
        const double distance = glm::length(towards);
        sum = sum + shade(surface, view, towards / distance) * (1 / (distance * distance * points));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        sum[c] *= static_cast<double>(light.intensity[static_cast<int>(c)]);
    }
    return sum;
}

} // namespace preview::reference
