#include "preview/scene/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace preview {

namespace {

/// Points with dot(normal, p) + offset >= 0.
struct HalfSpace {
    glm::dvec3 normal{0};
    double offset = 0;

    double of(glm::dvec3 p) const { return glm::dot(normal, p) + offset; }
};

HalfSpace half_space(glm::dvec4 plane) {
    const double length = glm::length(glm::dvec3(plane));
    return length > 0 ? HalfSpace{glm::dvec3(plane) / length, plane.w / length}
                      : HalfSpace{{}, plane.w};
}

/// The six sides of the box, then the near plane and the four sides of the frustum.
std::array<HalfSpace, 11> half_spaces(const Bounds& box, const glm::dmat4& rows) {
    std::array<HalfSpace, 11> out;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 along(0);
        along[axis] = 1;
        out[static_cast<std::size_t>(2 * axis)] = {along, -static_cast<double>(box.min[axis])};
        out[static_cast<std::size_t>(2 * axis + 1)] = {-along, static_cast<double>(box.max[axis])};
    }
    out[6] = half_space(rows[2]);
    out[7] = half_space(rows[3] + rows[0]);
    out[8] = half_space(rows[3] - rows[0]);
    out[9] = half_space(rows[3] + rows[1]);
    out[10] = half_space(rows[3] - rows[1]);
    return out;
}

/// The least of a linear function over a convex body is at one of its corners, and those are where
/// three of its planes meet.
double least_depth(const std::array<HalfSpace, 11>& planes, glm::dvec4 depth, double tolerance) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const glm::dvec3 along = glm::cross(planes[i].normal, planes[j].normal);
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                const double determinant = glm::dot(along, planes[k].normal);
                if (std::abs(determinant) < 1e-12) {
                    continue;
                }
                const glm::dvec3 corner =
                    -(planes[i].offset * glm::cross(planes[j].normal, planes[k].normal) +
                      planes[j].offset * glm::cross(planes[k].normal, planes[i].normal) +
                      planes[k].offset * along) /
                    determinant;
                if (std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
                        return plane.of(corner) >= -tolerance;
                    })) {
                    least = std::min(least, glm::dot(glm::dvec3(depth), corner) + depth.w);
                }
            }
        }
    }
    return least;
}

/// Of the box of an object that the frustum meets.
double nearest_of(const Bounds& box, const glm::dmat4& rows, double near_plane) {
    double least = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                           (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z};
        least = std::min(least, glm::dot(glm::dvec3(rows[3]), p) + rows[3].w);
    }
    if (least >= near_plane) {
        return least;
    }
    const double tolerance = 1e-6 * (1 + static_cast<double>(glm::distance(box.min, box.max)));
    const double within = least_depth(half_spaces(box, rows), rows[3], tolerance);
    // Only a rounding finds no corner of what is visible.
    return std::isfinite(within) ? std::max(within, near_plane) : near_plane;
}

} // namespace

float nearest_depth(const Scene& scene, const Geometry& geometry, const glm::mat4& clip,
                    float near_plane) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t index : visible_objects(scene, geometry, clip)) {
        const Object& object = scene.objects[index];
        const glm::dmat4 rows = glm::transpose(glm::dmat4(clip) * glm::dmat4(object.transform));
        nearest = std::min(nearest, nearest_of(geometry.meshes[object.mesh].bounds, rows,
                                               static_cast<double>(near_plane)));
    }
    return static_cast<float>(nearest);
}

} // namespace preview
