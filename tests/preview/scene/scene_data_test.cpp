// The scene in the shaders' form, and what each view needs of it; without a GPU.
#include "preview/scene/light_data.h"

#include "lutlib/named.h"
#include "preview/scene/light_controls.h"
#include "preview/scene/scene_data.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace preview {
namespace {

/// One unit ball at a place, under one casting light above the origin.
Scene ball_scene(glm::vec3 place) {
    Scene scene;
    scene.meshes.push_back(sphere(8, 16));
    scene.materials.push_back({});
    Object ball;
    ball.transform = glm::translate(glm::mat4(1), place);
    scene.objects.push_back(ball);
    PointLight light;
    light.position = {0, 5, 0};
    light.intensity = glm::vec3(10);
    light.casts_shadow = true;
    scene.lights.push_back(light);
    return scene;
}

glm::vec3 decode_octahedral(std::uint32_t bits) {
    const auto part = [&](unsigned shift) {
        return static_cast<float>(static_cast<std::int16_t>(bits >> shift & 0xffffU)) / 32767;
    };
    const float x = part(0);
    const float y = part(16);
    glm::vec3 v(x, y, 1 - std::abs(x) - std::abs(y));
    if (v.z < 0) {
        v.x = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
        v.y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
    }
    return glm::normalize(v);
}

TEST(SceneDataTest, octahedral_normals_come_back_within_a_hundredth_of_a_degree) {
    for (int step = 0; step < 2000; ++step) {
        const float z = 1 - 2 * (static_cast<float>(step) + 0.5F) / 2000;
        const float angle = 2.399963F * static_cast<float>(step);
        const float r = std::sqrt(1 - z * z);
        const glm::vec3 unit(r * std::cos(angle), r * std::sin(angle), z);
        // The chord is the angle for angles so small.
        EXPECT_LT(glm::length(decode_octahedral(encode_octahedral(unit)) - unit), 1.7e-4F);
    }
    EXPECT_EQ(encode_octahedral(glm::vec3(0)), 0U);
}

TEST(SceneDataTest, meshes_stand_one_after_the_other) {
    Scene scene = ball_scene({});
    scene.meshes.push_back(plane());
    const Geometry geometry = geometry_of(scene);
    ASSERT_EQ(geometry.meshes.size(), 2U);
    EXPECT_EQ(geometry.meshes[1].first_index, scene.meshes[0].indices.size());
    EXPECT_EQ(static_cast<std::size_t>(geometry.meshes[1].vertex_offset),
              scene.meshes[0].vertices.size());
    EXPECT_EQ(geometry.indices.size(),
              scene.meshes[0].indices.size() + scene.meshes[1].indices.size());
}

TEST(SceneDataTest, normals_stay_perpendicular_under_uneven_scales_and_mirrors) {
    for (const float mirror : {1.0F, -1.0F}) {
        Scene scene = ball_scene({});
        scene.objects[0].transform = glm::rotate(glm::mat4(1), 0.7F, glm::vec3(0.3F, 1, 0.2F)) *
                                     glm::scale(glm::mat4(1), glm::vec3(3 * mirror, 0.5F, 1));
        const ObjectBlock block = object_blocks(scene)[0];
        const auto normal = [&](glm::vec3 n) {
            const glm::vec4 q(n, 0);
            return glm::vec3(glm::dot(block.normal[0], q), glm::dot(block.normal[1], q),
                             glm::dot(block.normal[2], q));
        };
        const glm::vec3 n = glm::normalize(glm::vec3(0.5F, 0.6F, -0.3F));
        const glm::vec3 along = glm::normalize(glm::cross(n, glm::vec3(0, 0, 1)));
        const glm::vec3 moved(scene.objects[0].transform * glm::vec4(along, 0));
        EXPECT_NEAR(glm::dot(glm::normalize(normal(n)), glm::normalize(moved)), 0, 1e-5);
        const glm::vec3 outwards(scene.objects[0].transform * glm::vec4(n, 0));
        EXPECT_GT(glm::dot(normal(n), outwards), 0) << "mirror " << mirror;
    }
}

TEST(SceneDataTest, a_light_without_a_caster_or_a_receiver_in_its_frustum_says_so) {
    const auto shadow = [](const Scene& scene) {
        return shadow_of(scene, geometry_of(scene), scene.lights[0], 512);
    };
    const Scene inside = ball_scene({0, 1, 0});
    const LightShadow found = shadow(inside);
    ASSERT_EQ(found.views.size(), 1U);
    EXPECT_EQ(found.views[0].casters, std::vector<std::uint32_t>{0});
    EXPECT_EQ(found.faces, 0U);
    EXPECT_EQ(found.reason, "");

    EXPECT_EQ(shadow(ball_scene({0, 9, 0})).reason, "no caster in the light's frustum");
    EXPECT_EQ(shadow(ball_scene({9, 0, 0})).reason, "no caster in the light's frustum");

    Scene other = inside;
    other.objects[0].casts_shadow = false;
    EXPECT_EQ(shadow(other).reason, "no caster in the light's frustum");
    other = inside;
    other.materials[0].detail.is_unlit = true;
    EXPECT_EQ(shadow(other).reason, "no receiver in the light's frustum");
    other = inside;
    other.lights[0].intensity = {};
    EXPECT_EQ(shadow(other).reason, "the light's intensity is 0");
    other.lights[0].casts_shadow = false;
    EXPECT_EQ(shadow(other).reason, "the light casts none");
}

TEST(SceneDataTest, a_ring_or_rod_of_no_size_is_a_point_and_keeps_its_direction) {
    const LightControl& size = *lutlib::find_named(light_controls(), "size");
    for (const PointLight& found : scene_at(*scene_named("studio"), 0).lights) {
        if (found.shape == PointLight::Shape::point) {
            continue;
        }
        PointLight light = found;
        light.thickness = 0;
        EXPECT_NE(area_shape_of(light), 0U) << light.name;
        size.set(light, glm::vec3(0));
        EXPECT_EQ(area_shape_of(light), 0U) << light.name;
        EXPECT_EQ(light_block(light, {}, 0, 512).extent_shape.w, 0.0F) << light.name;
        size.set(light, glm::vec3(glm::length(found.extent), 0, 0));
        EXPECT_NE(area_shape_of(light), 0U) << light.name;
        EXPECT_LT(glm::length(light.extent - found.extent), 1e-5F) << light.name;
    }
}

TEST(SceneDataTest, a_sun_shines_from_one_direction_whatever_its_size_is_set_to) {
    PointLight sun;
    sun.is_sun = true;
    sun.aim = {1, -2, 0};
    const LightBlock before = light_block(sun, {}, 0, 512);
    sun.thickness = 0.5F;
    sun.extent = {1, 0, 0};
    sun.shape = PointLight::Shape::rod;
    EXPECT_EQ(area_shape_of(sun), 0U);
    const LightBlock block = light_block(sun, {}, 0, 512);
    EXPECT_EQ(block.up_thickness, before.up_thickness);
    EXPECT_EQ(block.extent_shape, before.extent_shape);
}

TEST(SceneDataTest, a_light_that_shadows_all_round_has_six_maps_and_looks_up_those_with_casters) {
    Scene scene = ball_scene({0, 1, 0});
    scene.lights[0].shadow_angle = PointLight::all_round;
    const LightShadow below = shadow_of(scene, geometry_of(scene), scene.lights[0], 512);
    ASSERT_EQ(below.views.size(), 6U);
    EXPECT_EQ(below.views[3].side, "-y");
    EXPECT_EQ(below.views[3].casters, std::vector<std::uint32_t>{0});
    EXPECT_TRUE(below.views[2].casters.empty());
    EXPECT_EQ(below.faces, 1U << 3U);
    scene.lights[0].position = {0, 1, 0};
    const LightShadow about = shadow_of(scene, geometry_of(scene), scene.lights[0], 512);
    EXPECT_EQ(about.views.size(), 6U);
    EXPECT_EQ(about.faces, 63U);
    for (std::size_t face = 0; face < 6; ++face) {
        const ShadowFrustum& frustum = about.views[face].frustum;
        const glm::mat4 clip = shadow_clip(scene.lights[0], frustum);
        // A direction on the edge of the face's own side stands inside of the map, by the filter's
        // reach.
        const glm::vec3 edge = frustum.forward + frustum.right;
        const glm::vec4 p = clip * glm::vec4(scene.lights[0].position + edge, 1);
        EXPECT_NEAR((1 - p.x / p.w) * 256, 3, 0.01) << face;
    }
}

TEST(SceneDataTest, a_shadow_map_looks_at_the_lights_aim_from_near_to_far) {
    for (const glm::vec3 aim : {glm::vec3(0, 0, 0), glm::vec3(3, 1, 2)}) {
        Scene scene = ball_scene(0.5F * aim);
        PointLight& light = scene.lights[0];
        light.aim = aim;
        light.shadow_near = 0.5F;
        light.shadow_far = 10;
        const LightShadow shadow = shadow_of(scene, geometry_of(scene), light, 512);
        ASSERT_EQ(shadow.views.size(), 1U);
        const glm::mat4 clip = shadow_clip(light, shadow.views[0].frustum);
        const glm::vec3 towards = glm::normalize(aim - light.position);
        const auto depth = [&](float distance) {
            const glm::vec4 p = clip * glm::vec4(light.position + towards * distance, 1);
            EXPECT_NEAR(p.x, 0, 1e-5);
            EXPECT_NEAR(p.y, 0, 1e-5);
            return p.z / p.w;
        };
        EXPECT_NEAR(depth(0.5F), 0, 1e-5);
        EXPECT_NEAR(depth(10), 1, 1e-5);
    }
}

TEST(SceneDataTest, what_is_behind_the_camera_is_not_drawn) {
    for (const SceneInfo& info : scenes()) {
        const Scene scene = scene_at(info, 0);
        const Geometry geometry = geometry_of(scene);
        EXPECT_EQ(draws_of(scene, geometry, {}).size(), 0U);
        EXPECT_GT(visible_objects(scene, geometry, view_block(scene.orbit, 1.78F).clip).size(), 0U)
            << info.name;
    }
    Scene scene = ball_scene({0, 0, 9});
    scene.orbit.distance = 5;
    scene.orbit.elevation = 0;
    EXPECT_TRUE(
        visible_objects(scene, geometry_of(scene), view_block(scene.orbit, 1).clip).empty());
    scene.objects[0].transform = glm::mat4(1);
    EXPECT_EQ(visible_objects(scene, geometry_of(scene), view_block(scene.orbit, 1).clip).size(),
              1U);
}

TEST(SceneDataTest, a_pixels_ray_times_its_depth_is_the_point_it_shows) {
    Orbit orbit;
    orbit.azimuth = 33;
    orbit.elevation = 21;
    for (const float aspect : {0.5F, 1.0F, 2.4F}) {
        const ViewBlock view = view_block(orbit, aspect);
        const glm::vec3 point(0.4F, -0.3F, 0.7F);
        const glm::vec4 clip = view.clip * glm::vec4(point, 1);
        const glm::vec3 screen = glm::vec3(clip) / clip.w;
        const glm::vec3 ray = glm::vec3(view.forward) + screen.x * glm::vec3(view.right) +
                              screen.y * glm::vec3(view.up);
        const float depth = view.position_near.w / (1 - screen.z);
        EXPECT_LT(glm::length(glm::vec3(view.position_near) + depth * ray - point), 1e-4F);
    }
}

} // namespace
} // namespace preview
