// Cameras of glTF files, seen as their makers see through them.
#include "preview/scene/scene.h"
#include "tests/preview/scene/import_fixture.h"

#include <cmath>
#include <numbers>

namespace preview {
namespace {

TEST_F(ImportTest, cameras_that_look_straight_down_or_up_have_their_own_top) {
    for (const float side : {-1.0F, 1.0F}) { // down, as Blender's unturned one; up
        GltfWriter gltf = one_square();
        gltf.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}}}});
        gltf.add_node({{"camera", 0},
                       {"translation", {0, -6 * side, 0}},
                       {"rotation", {side * std::sqrt(.5), 0, 0, std::sqrt(.5)}}});
        const Scene scene = import(gltf).scene;
        const Camera camera = camera_of(scene.cameras.at(0).orbit, 16.0F / 9);
        // The camera's right is x, its top -z when it looks down and z when up.
        const glm::vec4 clip =
            camera.projection * camera.view * scene.objects[0].transform * glm::vec4(1, 0, side, 1);
        EXPECT_GT(clip.x / clip.w, 0.05F) << side;
        EXPECT_LT(clip.y / clip.w, -0.05F) << side << ": y points down";
    }
}

TEST_F(ImportTest, cameras_have_names_and_roll_and_may_be_orthographic) {
    GltfWriter gltf = one_square();
    gltf.add("cameras",
             {{"name", "tilted"}, {"type", "perspective"}, {"perspective", {{"yfov", .5}}}});
    gltf.add("cameras", {{"type", "orthographic"},
                         {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}});
    // By 30 degrees about the axis that it looks along: its top goes to the left.
    const double half = std::numbers::pi / 12;
    gltf.add_node({{"camera", 0},
                   {"translation", {0, 0, 6}},
                   {"rotation", {0, 0, std::sin(half), std::cos(half)}}});
    gltf.add_node({{"camera", 1}, {"name", "flat"}, {"translation", {1, 0, 3}}});
    const Scene scene = import(gltf).scene;
    ASSERT_EQ(scene.cameras.size(), 2U);
    EXPECT_EQ(scene.cameras[0].name, "tilted");
    EXPECT_EQ(scene.cameras[1].name, "flat");
    EXPECT_NEAR(scene.cameras[0].orbit.roll, 30, 1e-3);
    const glm::mat4& fit = scene.objects[0].transform;
    const auto shown = [&](const Orbit& orbit, glm::vec3 point) {
        const Camera camera = camera_of(orbit, 16.0F / 9);
        const glm::vec4 clip = camera.projection * camera.view * fit * glm::vec4(point, 1);
        return glm::vec3(clip) / clip.w;
    };
    // What lies along the camera's own up is straight above the middle; y points down there.
    const float a = std::numbers::pi_v<float> / 6;
    const glm::vec3 above = shown(scene.cameras[0].orbit, {-std::sin(a), std::cos(a), 0});
    EXPECT_NEAR(above.x, 0, rounding);
    EXPECT_NEAR(above.y, -1 / (6 * std::tan(.25F)), 1e-3);
    // Parallel rays: half the height is 2 units at every distance, to half a percent.
    for (const float z : {-1.0F, 0.0F, 1.0F}) {
        expect_near(shown(scene.cameras[1].orbit, {1, 1, z}) * glm::vec3(1, 1, 0), {0, -.5F, 0},
                    .004F);
    }
}

} // namespace
} // namespace preview
