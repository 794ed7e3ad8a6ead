// The bound of how near what the camera sees may be, against points of what it sees.
#include "preview/scene/nearest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace preview {
namespace {

/// The nearest of the vertices and of points between them that lie in the picture.
float nearest_point(const Scene& scene, const Geometry& geometry, const glm::mat4& clip) {
    float out = INFINITY;
    const auto look_at = [&](const glm::vec4& point) {
        if (std::abs(point.x) <= point.w && std::abs(point.y) <= point.w && point.z >= 0) {
            out = std::min(out, point.w);
        }
    };
    for (const Object& object : scene.objects) {
        const Geometry::Range& range = geometry.meshes[object.mesh];
        const glm::mat4 to_clip = clip * object.transform;
        for (std::uint32_t i = 0; i < range.index_count; i += 3) {
            glm::vec4 corners[3];
            for (std::uint32_t n = 0; n < 3; ++n) {
                const auto vertex = static_cast<std::size_t>(range.vertex_offset) +
                                    geometry.indices[range.first_index + i + n];
                corners[n] = to_clip * glm::vec4(geometry.vertices[vertex].position, 1);
            }
            for (int u = 0; u <= 8; ++u) {
                for (int v = 0; u + v <= 8; ++v) {
                    const float a = static_cast<float>(u) / 8, b = static_cast<float>(v) / 8;
                    look_at(a * corners[0] + b * corners[1] + (1 - a - b) * corners[2]);
                }
            }
        }
    }
    return out;
}

TEST(NearestDepth, is_no_farther_than_what_the_camera_sees_and_not_much_nearer) {
    // The box of the other scenes' backdrop has the camera in it.
    for (const char* name : {"plain", "studio", "sample", "night", "exterior"}) {
        const bool is_in_a_box = name[0] == 'p' || std::string_view(name) == "studio";
        const Scene scene = scene_at(*scene_named(name), 0);
        const Geometry geometry = geometry_of(scene);
        const glm::mat4 clip = view_block(scene.orbit, 16.0F / 9).clip;
        const float bound = nearest_depth(scene, geometry, clip, scene.orbit.near_plane);
        const float seen = nearest_point(scene, geometry, clip);
        EXPECT_LE(bound, seen * 1.0001F) << name;
        EXPECT_GT(bound, is_in_a_box ? 0 : 0.3F * seen) << name;
    }
}

TEST(NearestDepth, is_the_near_plane_within_an_object_and_infinite_where_there_is_none) {
    Scene scene;
    scene.meshes = {sphere(8, 16)};
    scene.materials.emplace_back();
    const Geometry geometry = geometry_of(scene);
    const glm::mat4 clip = view_block(scene.orbit, 1).clip;
    EXPECT_EQ(nearest_depth(scene, geometry, clip, scene.orbit.near_plane), INFINITY);
    scene.objects.emplace_back();
    EXPECT_NEAR(nearest_depth(scene, geometry, clip, scene.orbit.near_plane),
                scene.orbit.distance - 1.3F, 0.3F);
    scene.objects.front().transform = glm::mat4(20);
    scene.objects.front().transform[3] = glm::vec4(0, 0, 0, 1);
    EXPECT_NEAR(nearest_depth(scene, geometry, clip, scene.orbit.near_plane),
                scene.orbit.near_plane, 1e-6F);
}

} // namespace
} // namespace preview
