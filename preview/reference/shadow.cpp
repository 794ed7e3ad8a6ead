#include "preview/reference/shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace preview::reference {

Casters::Casters(const Scene& scene) {
    for (const Object& object : scene.objects) {
        if (!object.casts_shadow) {
            continue;
        }
        const Mesh& mesh = scene.meshes[object.mesh];
        const glm::dmat4 to_world(object.transform);
        for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
            std::array<glm::dvec3, 3> corners;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                corners[corner] = glm::dvec3(
                    to_world *
                    glm::dvec4(glm::dvec3(mesh.vertices[mesh.indices[at + corner]].position), 1));
            }
            triangles_.push_back(corners);
        }
    }
}

// Moeller and Trumbore 1997, "Fast, minimum storage ray-triangle intersection".
bool Casters::block(glm::dvec3 from, glm::dvec3 to, double least) const {
    const glm::dvec3 ray = to - from;
    const double length = glm::length(ray);
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const auto& corners) {
        const glm::dvec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
        const glm::dvec3 p = glm::cross(ray, b);
        const double determinant = glm::dot(a, p);
        if (std::abs(determinant) < 1e-15) {
            return false;
        }
        const glm::dvec3 away = from - corners[0];
        const double u = glm::dot(away, p) / determinant;
        const glm::dvec3 q = glm::cross(away, a);
        const double v = glm::dot(ray, q) / determinant;
        const double t = glm::dot(b, q) / determinant;
        return u >= 0 && v >= 0 && u + v <= 1 && t * length > least && t < 1;
    });
}

} // namespace preview::reference
