// G-buffer and lighting on a device, against what they must show.
#include "preview/reference/area_light.h"
#include "preview/reference/ggx.h"
#include "tests/preview/passes/lit_fixture.h"

namespace preview {
namespace {

TEST_F(GeometryTest, lights_a_floor_as_the_double_reference_does) {
    for (const float metalness : {0.0F, 1.0F}) {
        for (const float roughness : {0.0F, 0.2F, 0.5F, 1.0F}) {
            const Material material{{0.8F, 0.4F, 0.1F}, roughness, metalness, {}};
            const Scene scene = floor_scene(material);
            const auto pixels = light(scene);
            const ViewBlock view = view_block(scene.orbit, 1.5F);
            for (std::uint32_t y = 0; y < size.height; ++y) {
                for (std::uint32_t x = 0; x < size.width; ++x) {
                    glm::dvec3 ray;
                    const glm::dvec3 at = on_floor(view, x, y, ray);
                    if (ray.y >= 0 || std::abs(at.x) > 9 || std::abs(at.z) > 9) {
                        continue;
                    }
                    const glm::dvec3 towards = glm::dvec3(scene.lights[0].position) - at;
                    const reference::Surface surface{
                        {0, 1, 0}, {0.8, 0.4, 0.1}, roughness, metalness};
                    const lutlib::RgbD shaded =
                        reference::shade(surface, -glm::normalize(ray), glm::normalize(towards));
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double expected =
                            shaded[c] *
                            static_cast<double>(scene.lights[0].intensity[static_cast<int>(c)]) /
                            glm::dot(towards, towards);
                        const double found =
                            static_cast<double>(pixels[(std::size_t{y} * size.width + x) * 4 + c]);
                        // Half floats are truncated (2^-10), and the sharpest lobe turns the last
                        // bits of depth and 16-bit normals into 1 % of its value.
                        const double bound = (roughness < 0.1F ? 0.03 : 0.004) * expected + 1e-4;
                        ASSERT_NEAR(found, expected, bound)
                            << "roughness " << roughness << " at " << x << "," << y;
                    }
                }
            }
        }
    }
}

TEST_F(GeometryTest, a_spot_lights_its_cone_alone_and_falls_off_as_gltf_has_it) {
    Scene scene = floor_scene({});
    const auto everywhere = light(scene);
    PointLight& spot = scene.lights[0];
    spot.axis = glm::normalize(glm::vec3(0.3F, -1, 0.1F));
    spot.inner_angle = 15;
    spot.outer_angle = 40;
    const auto pixels = light(scene);
    const ViewBlock view = view_block(scene.orbit, 1.5F);
    std::size_t dark = 0, between = 0, full = 0;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const double sx = (x + 0.5) / size.width * 2 - 1;
            const double sy = (y + 0.5) / size.height * 2 - 1;
            const glm::dvec3 ray =
                glm::dvec3(view.forward) + sx * glm::dvec3(view.right) + sy * glm::dvec3(view.up);
            const glm::dvec3 eye(view.position_near);
            const glm::dvec3 at = eye - ray * (eye.y / ray.y);
            if (ray.y >= 0 || std::abs(at.x) > 9 || std::abs(at.z) > 9) {
                continue;
            }
            const double along =
                glm::dot(glm::normalize(at - glm::dvec3(spot.position)), glm::dvec3(spot.axis));
            const double inner = std::cos(glm::radians(15.0)), outer = std::cos(glm::radians(40.0));
            const double share = std::clamp((along - outer) / (inner - outer), 0.0, 1.0);
            dark += share == 0 ? 1 : 0;
            full += share == 1 ? 1 : 0;
            between += share > 0 && share < 1 ? 1 : 0;
            const std::size_t index = (std::size_t{y} * size.width + x) * 4;
            const auto all = static_cast<double>(everywhere[index]);
            // Both are half floats.
            ASSERT_NEAR(static_cast<double>(pixels[index]), all * share * share, 0.003 * all + 1e-4)
                << x << "," << y;
        }
    }
    EXPECT_GT(std::min({dark, between, full}), 100U);
}

TEST_F(GeometryTest, a_light_with_a_reach_fades_as_gltf_has_it) {
    Scene scene = floor_scene({});
    const auto everywhere = light(scene);
    PointLight& lamp = scene.lights[0];
    lamp.reach = 3;
    const auto pixels = light(scene);
    const ViewBlock view = view_block(scene.orbit, 1.5F);
    std::size_t dark = 0, between = 0;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            glm::dvec3 ray;
            const glm::dvec3 at = on_floor(view, x, y, ray);
            if (ray.y >= 0 || std::abs(at.x) > 9 || std::abs(at.z) > 9) {
                continue;
            }
            const double part = glm::length(at - glm::dvec3(lamp.position)) / 3;
            const double left = std::clamp(1 - part * part * part * part, 0.0, 1.0);
            dark += left == 0 ? 1 : 0;
            between += left > 0 ? 1 : 0;
            const std::size_t index = (std::size_t{y} * size.width + x) * 4;
            const auto all = static_cast<double>(everywhere[index]);
            ASSERT_NEAR(static_cast<double>(pixels[index]), all * left, 0.003 * all + 1e-4)
                << x << "," << y;
        }
    }
    EXPECT_GT(std::min(dark, between), 300U);
    lamp.is_sun = true; // a sun's rays have come from infinity
    const auto sunny = light(scene);
    lamp.reach = 0;
    EXPECT_EQ(light(scene), sunny);
}

TEST_F(GeometryTest, lights_left_out_where_their_cones_and_reach_end_change_no_bit) {
    Scene scene = floor_scene({{0.8F, 0.4F, 0.1F}, 0.3F, 0, {}});
    const PointLight lamp = scene.lights[0];
    scene.lights.clear();
    // From pencils to more than half of all directions, above the floor and below it, some without
    // a cone.
    constexpr int count = 70;
    for (int i = 0; i < count; ++i) {
        PointLight light = lamp;
        const auto t = static_cast<float>(i);
        light.position = {std::fmod(t * 1.37F, 8.0F) - 4, i % 9 == 0 ? -0.3F : 0.2F + 0.05F * t,
                          std::fmod(t * 0.77F, 6.0F) - 3};
        light.intensity = glm::vec3(0.5F + std::fmod(t, 3.0F), 1, 2);
        light.axis = glm::normalize(glm::vec3(std::sin(t), -1 + 0.02F * t, std::cos(2 * t)));
        light.inner_angle = 0.1F * t;
        light.outer_angle = i % 7 == 0 ? 180 : 1 + 1.6F * t;
        light.reach = i % 3 == 0 ? 0.1F + 0.07F * t : 0;
        scene.lights.push_back(light);
    }
    const auto listed = light(scene, 64, true);
    EXPECT_EQ(listed, light(scene, 64));
    // Each of them counts: with any of the spots switched off something else is seen.
    std::size_t seen = 0;
    for (std::size_t i = 0; i < scene.lights.size(); i += 5) {
        Scene without = scene;
        without.lights[i].intensity = glm::vec3(0);
        seen += light(without, 64, true) != listed ? 1 : 0;
    }
    EXPECT_GT(seen, 9U);
}

TEST_F(GeometryTest, balls_rods_and_rings_light_a_floor_nearly_as_their_integral_does) {
    struct Case {
        PointLight::Shape shape;
        float roughness, metalness;
        double bound; ///< of the mean error over the mean light
    };
    // A rough dielectric is lit by the exact irradiance; highlights are approximations.
    for (const auto& [shape, roughness, metalness, bound] :
         {Case{PointLight::Shape::point, 1, 0, 0.01}, Case{PointLight::Shape::point, 0.5F, 1, 0.1},
          Case{PointLight::Shape::point, 0.25F, 1, 0.3}, Case{PointLight::Shape::rod, 1, 0, 0.01},
          Case{PointLight::Shape::rod, 0.5F, 1, 0.3}, Case{PointLight::Shape::rod, 0.25F, 1, 0.3},
          Case{PointLight::Shape::ring, 1, 0, 0.01}, Case{PointLight::Shape::ring, 0.5F, 1, 0.2},
          Case{PointLight::Shape::ring, 0.25F, 1, 0.25}}) {
        Scene scene = floor_scene({{0.8F, 0.4F, 0.1F}, roughness, metalness, {}});
        PointLight& area = scene.lights[0];
        area.position = {0.2F, 1, -0.8F};
        area.shape = shape;
        area.extent =
            shape == PointLight::Shape::rod ? glm::vec3(0.6F, 0.3F, 0) : glm::vec3(0, 0.1F, 0.5F);
        const auto pixels = light(scene);
        const ViewBlock view = view_block(scene.orbit, 1.5F);
        double sum = 0, error = 0;
        for (std::uint32_t y = 0; y < size.height; y += 3) {
            for (std::uint32_t x = 0; x < size.width; x += 3) {
                glm::dvec3 ray;
                const glm::dvec3 at = on_floor(view, x, y, ray);
                if (ray.y >= 0 || std::abs(at.x) > 9 || std::abs(at.z) > 9) {
                    continue;
                }
                const lutlib::RgbD expected =
                    reference::shade_area(area,
                                          {{0, 1, 0},
                                           {0.8, 0.4, 0.1},
                                           static_cast<double>(roughness),
                                           static_cast<double>(metalness)},
                                          at, -glm::normalize(ray), 400);
                const auto found =
                    static_cast<double>(pixels[(std::size_t{y} * size.width + x) * 4]);
                sum += expected.r;
                error += std::abs(found - expected.r);
            }
        }
        EXPECT_LT(error / sum, bound) << static_cast<int>(shape) << " " << roughness;
    }
}

TEST_F(GeometryTest, every_scene_is_finite_and_not_black) {
    for (const SceneInfo& info : scenes()) {
        const auto pixels = light(scene_at(info, 0));
        float sum = 0;
        for (const float value : pixels) {
            ASSERT_TRUE(std::isfinite(value)) << info.name;
            ASSERT_GE(value, 0) << info.name;
            sum += value;
        }
        EXPECT_GT(sum / static_cast<float>(pixels.size()), 0.01F) << info.name;
    }
}

TEST_F(GeometryTest, without_lights_and_surroundings_a_scene_is_black) {
    Scene scene = floor_scene({});
    scene.lights.clear();
    const auto pixels = light(scene);
    for (std::size_t at = 0; at < pixels.size(); at += 4) {
        ASSERT_EQ(pixels[at] + pixels[at + 1] + pixels[at + 2], 0);
    }
}

} // namespace
} // namespace preview
