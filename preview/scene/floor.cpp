#include "preview/scene/floor.h"

#include "preview/scene/builtin.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace preview {

bool has_floor(const Scene& scene) {
    const Bounds box = scene.bounds();
    const glm::vec3 size = box.max - box.min;
    const float highest = box.min.y + 0.05F * size.y;
    float covered = 0;
    Bounds above;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
            std::array<glm::vec3, 3> corner{};
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::vec3 place = mesh.vertices[mesh.indices[at + i]].position;
                corner[i] = glm::vec3(object.transform * glm::vec4(place, 1));
            }
            if (std::max({corner[0].y, corner[1].y, corner[2].y}) <= highest) {
                // Seen from above, and only where it faces up.
                const glm::vec3 area =
                    glm::cross(corner[1] - corner[0], corner[2] - corner[0]) * 0.5F;
                covered += std::max(area.y, 0.0F);
                continue;
            }
            for (const glm::vec3& place : corner) {
                above.include(place);
            }
        }
    }
    const float ground = size.x * size.z;
    const glm::vec3 standing = above.empty() ? glm::vec3(0) : above.max - above.min;
    return ground > 0 && covered >= 0.5F * ground && standing.x * standing.z <= 0.8F * ground;
}

void add_floor(Scene& scene) {
    const Bounds box = scene.bounds();
    const float radius = 1.1F * glm::length(box.max - box.min);
    const float thickness = 0.02F * radius;
    scene.meshes.push_back(cylinder(128));
    scene.meshes.back().name = "floor";
    scene.materials.push_back({.albedo = glm::vec3(0.3F), .roughness = 0.6F});
    const glm::vec3 middle((box.min.x + box.max.x) / 2, box.min.y - thickness / 2,
                           (box.min.z + box.max.z) / 2);
    scene.floor = static_cast<std::uint32_t>(scene.objects.size());
    scene.objects.push_back({static_cast<std::uint32_t>(scene.meshes.size() - 1),
                             static_cast<std::uint32_t>(scene.materials.size() - 1),
                             at(middle, {radius, thickness / 2, radius}), false});
}

} // namespace preview
