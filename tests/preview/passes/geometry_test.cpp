// G-buffer, shadow maps, lighting and HDR resolve on a device, against what they must show.
#include "preview/passes/lighting.h"
#include "preview/passes/resolve.h"
#include "preview/passes/shadow.h"
#include "preview/reference/area_light.h"
#include "preview/reference/ggx.h"
#include "preview/reference/shadow.h"
#include "preview/scene/gpu_scene.h"
#include "tests/preview/graph/gpu_test.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace preview {
namespace {

constexpr Size size{96, 64};

float float_of_half(std::uint16_t half) {
    const int exponent = half >> 10 & 31;
    const float sign = (half & 0x8000) != 0 ? -1.0F : 1.0F;
    const auto mantissa = static_cast<float>(half & 1023);
    if (exponent == 31) {
        return mantissa > 0 ? std::numeric_limits<float>::quiet_NaN()
                            : sign * std::numeric_limits<float>::infinity();
    }
    return sign *
           (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(mantissa + 1024, exponent - 25));
}

std::vector<float> floats_of(const std::vector<std::uint16_t>& halves) {
    std::vector<float> floats;
    for (const std::uint16_t half : halves) {
        floats.push_back(float_of_half(half));
    }
    return floats;
}

/// A floor of 20 m at y = 0 under one light; the camera looks down at it from the front.
Scene floor_scene(const Material& material) {
    Scene scene;
    scene.meshes.push_back(plane());
    scene.materials.push_back(material);
    Object floor;
    floor.transform = glm::scale(glm::mat4(1), glm::vec3(10));
    scene.objects.push_back(floor);
    PointLight light;
    light.position = {0.7F, 2, -0.4F};
    light.intensity = {30, 20, 10};
    light.shadow_angle = 100;
    scene.lights.push_back(light);
    scene.orbit.elevation = 35;
    scene.orbit.distance = 4;
    return scene;
}

class GeometryTest : public GpuTest {
  protected:
    /// Radiance of the scene, four floats a pixel.
    std::vector<float> light(const Scene& scene, std::uint32_t map_size = 512) {
        const GpuScene gpu_scene(device(), scene);
        Graph graph;
        const ViewBlock view = view_block(scene.orbit, 1.5F);
        SceneHandles handles = import_scene(graph, scene, gpu_scene, view);
        handles.environment = graph.data_of("environment", environment_block(scene.environment));
        ShadowMaps shadows;
        shadows.size = map_size;
        std::vector<LightBlock> lights;
        for (const PointLight& light : scene.lights) {
            const LightShadow shadow = shadow_of(scene, gpu_scene.geometry, light, shadows.size);
            const int layer = shadows.add(light, scene, gpu_scene.geometry, shadow);
            lights.push_back(light_block(light, shadow, layer, shadows.size));
        }
        handles.has_suns = std::any_of(scene.lights.begin(), scene.lights.end(),
                                       [](const PointLight& light) { return light.is_sun; });
        if (!lights.empty()) {
            handles.lights = graph.data("lights", std::as_bytes(std::span(lights)));
        }
        handles.light_count = static_cast<std::uint32_t>(lights.size());
        handles.has_spots = std::any_of(scene.lights.begin(), scene.lights.end(),
                                        [](const PointLight& light) { return light.is_spot(); });
        handles.has_areas =
            std::any_of(scene.lights.begin(), scene.lights.end(), [](const PointLight& light) {
                return light.shape != PointLight::Shape::point;
            });
        LightingInputs inputs;
        inputs.shadow_maps = add_shadows(graph, handles, std::move(shadows));
        inputs.surfaces =
            add_gbuffer(graph, handles, size,
                        draws_of(scene, gpu_scene.geometry,
                                 visible_objects(scene, gpu_scene.geometry, view.clip)));
        inputs.environment = !scene.environment.is_black();
        const ImageHandle lit = add_lighting(graph, handles, inputs);
        graph.present(lit);
        return floats_of(run_and_read<std::uint16_t>(graph, lit));
    }
};

/// Where the ray of a pixel's centre meets the floor; above the horizon, nothing sensible.
glm::dvec3 on_floor(const ViewBlock& view, std::uint32_t x, std::uint32_t y, glm::dvec3& ray) {
    const double sx = (x + 0.5) / size.width * 2 - 1;
    const double sy = (y + 0.5) / size.height * 2 - 1;
    ray = glm::dvec3(view.forward) + sx * glm::dvec3(view.right) + sy * glm::dvec3(view.up);
    const glm::dvec3 eye(view.position_near);
    return eye - ray * (eye.y / ray.y);
}

TEST_F(GeometryTest, a_sun_shines_in_parallel_and_its_shadow_goes_on_behind_its_casters) {
    Scene scene = floor_scene({{0.8F, 0.4F, 0.1F}, 0.5F, 0, {}});
    scene.objects[0].casts_shadow = false;
    Object ball;
    ball.mesh = 1;
    ball.transform = glm::scale(glm::translate(glm::mat4(1), {-1, 1, 0}), glm::vec3(0.3F));
    scene.meshes.push_back(sphere(24, 48));
    scene.objects.push_back(ball);
    PointLight& sun = scene.lights[0];
    sun.is_sun = sun.casts_shadow = true;
    sun.intensity = {3, 2, 1};
    sun.position = glm::vec3(-std::sqrt(3.0F), 1, 0); // 30 degrees high
    const glm::dvec3 towards(sun.towards_sun());
    const auto pixels = light(scene);
    const ViewBlock view = view_block(scene.orbit, 1.5F);
    int shaded = 0;
    int shining = 0;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            glm::dvec3 ray;
            const glm::dvec3 at = on_floor(view, x, y, ray);
            const glm::dvec3 to_ball = glm::dvec3(-1, 1, 0) - at;
            const double miss = glm::length(to_ball - towards * glm::dot(to_ball, towards)) / 0.3;
            const glm::dvec3 eye(view.position_near);
            const glm::dvec3 before = glm::dvec3(-1, 1, 0) - eye;
            const glm::dvec3 unit = glm::normalize(ray);
            const bool is_hidden = glm::length(before - unit * glm::dot(before, unit)) < 0.35;
            // The outermost tenth is the filter's.
            if (ray.y >= 0 || std::abs(at.x) > 9 || std::abs(at.z) > 9 || is_hidden ||
                std::abs(miss - 1) < 0.1) {
                continue;
            }
            const float found = pixels[(std::size_t{y} * size.width + x) * 4];
            if (miss < 1) {
                EXPECT_EQ(found, 0) << x << ' ' << y;
                ++shaded;
                continue;
            }
            const lutlib::RgbD expected = reference::shade({{0, 1, 0}, {0.8, 0.4, 0.1}, 0.5, 0},
                                                           -glm::normalize(ray), towards);
            EXPECT_NEAR(found, expected[0] * 3, 0.004 * expected[0] * 3) << x << ' ' << y;
            ++shining;
        }
    }
    EXPECT_GT(shaded, 20);
    EXPECT_GT(shining, 1000);
}

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

TEST_F(GeometryTest, a_lit_floor_does_not_shadow_itself) {
    Scene scene = floor_scene({});
    const auto free_of_shadows = light(scene);
    scene.lights[0].casts_shadow = true;
    const auto pixels = light(scene);
    for (std::size_t at = 0; at < pixels.size(); ++at) {
        ASSERT_EQ(pixels[at], free_of_shadows[at]) << at;
    }
}

TEST_F(GeometryTest, a_ball_shadows_what_lies_behind_it_and_nothing_else) {
    Scene scene = floor_scene({});
    scene.meshes.push_back(sphere(24, 48));
    Object ball;
    ball.mesh = 1;
    ball.transform = glm::translate(glm::mat4(1), glm::vec3(0.35F, 1, -0.2F)) *
                     glm::scale(glm::mat4(1), glm::vec3(0.2F));
    scene.objects.push_back(ball);
    const auto free_of_shadows = light(scene);
    scene.lights[0].casts_shadow = true;
    const auto pixels = light(scene);
    const ViewBlock view = view_block(scene.orbit, 1.5F);
    const auto at_floor = [&](glm::vec3 point) {
        const glm::vec4 clip = view.clip * glm::vec4(point, 1);
        const auto x = static_cast<std::size_t>((clip.x / clip.w * 0.5F + 0.5F) * size.width);
        const auto y = static_cast<std::size_t>((clip.y / clip.w * 0.5F + 0.5F) * size.height);
        return (y * size.width + x) * 4;
    };
    const std::size_t shadowed = at_floor({0, 0, 0}); // the light through the ball's centre
    EXPECT_GT(free_of_shadows[shadowed], 0.1F);
    EXPECT_EQ(pixels[shadowed], 0);
    for (const glm::vec3 point : {glm::vec3(1.4F, 0, 0.5F), glm::vec3(-1.2F, 0, 0.3F)}) {
        EXPECT_EQ(pixels[at_floor(point)], free_of_shadows[at_floor(point)]);
    }
}

TEST_F(GeometryTest, shadows_are_what_rays_find_wherever_they_are_not_at_an_edge) {
    Scene scene = floor_scene({});
    scene.meshes.push_back(sphere(12, 24));
    scene.meshes.push_back(box({0.3F, 0.3F, 0.3F}, 0.02F, 2));
    for (const auto& [mesh, place] : {std::pair{1U, glm::vec3(0.9F, 0.4F, 0.3F)},
                                      {2U, glm::vec3(-0.6F, 0.3F, -0.2F)},
                                      {2U, glm::vec3(0.2F, 0.3F, -1.2F)}}) {
        const float scale = mesh == 1 ? 0.4F : 1.0F;
        scene.objects.push_back(
            {mesh, 0, glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(scale)), true});
    }
    PointLight& light = scene.lights[0];
    light.position = {0.15F, 0.5F, -0.1F}; // among the objects
    light.shadow_near = 0.05F;
    for (const float angle : {PointLight::all_round, 140.0F}) {
        const bool is_aimed = angle < 180;
        const std::uint32_t map_size = is_aimed ? 512 : 256;
        light.casts_shadow = false;
        const auto bare = this->light(scene, map_size);
        light.casts_shadow = true;
        light.shadow_angle = angle;
        light.aim = {0.15F, 0, -0.1F};
        const auto pixels = this->light(scene, map_size);
        const reference::Casters casters(scene);
        const ViewBlock view = view_block(scene.orbit, 1.5F);
        const glm::dvec3 source(light.position);
        int lit = 0, dark = 0, wrong = 0;
        for (std::uint32_t y = 0; y < size.height; y += 2) {
            for (std::uint32_t x = 0; x < size.width; x += 2) {
                const double sx = (x + 0.5) / size.width * 2 - 1;
                const double sy = (y + 0.5) / size.height * 2 - 1;
                const glm::dvec3 ray = glm::dvec3(view.forward) + sx * glm::dvec3(view.right) +
                                       sy * glm::dvec3(view.up);
                const glm::dvec3 eye(view.position_near);
                const glm::dvec3 at = eye - ray * (eye.y / ray.y);
                const double far = std::max(std::abs(at.x - source.x), std::abs(at.z - source.z));
                // The frustum of 140 degrees has its edge at 1.37 m.
                if (ray.y >= 0 || std::abs(at.x) > 3 || std::abs(at.z) > 3 ||
                    casters.block(at, eye) || (is_aimed && far > 1.3)) {
                    continue;
                }
                // Over what the filter sees, and half a texel more; the floor is parallel to the
                // aimed map, and to others it slants.
                const glm::dvec3 towards = source - at;
                const double length = glm::length(towards);
                const double texel = is_aimed
                                         ? 2 * std::tan(glm::radians(70.0)) / map_size * source.y
                                         : 2 * 1.03 / map_size * length * length / towards.y;
                int blocked = 0;
                for (const glm::dvec3 corner : {glm::dvec3(0),
                                                {1, 0, 1},
                                                {1, 0, -1},
                                                {-1, 0, 1},
                                                {-1, 0, -1},
                                                {1.4, 0, 0},
                                                {-1.4, 0, 0},
                                                {0, 0, 1.4},
                                                {0, 0, -1.4}}) {
                    blocked += casters.block(at + 2.0 * texel * corner, source) ? 1 : 0;
                }
                const std::size_t index = (std::size_t{y} * size.width + x) * 4;
                if (blocked == 0) {
                    ++lit;
                    wrong += pixels[index] == bare[index] ? 0 : 1;
                } else if (blocked == 9) {
                    ++dark;
                    wrong += pixels[index] == 0 ? 0 : 1;
                }
            }
        }
        EXPECT_GT(lit, 100);
        EXPECT_GT(dark, is_aimed ? 20 : 100);
        EXPECT_EQ(wrong, 0) << angle << ": of " << lit << " lit and " << dark << " dark";
    }
}

TEST_F(GeometryTest, a_small_block_shadows_the_floor_right_where_it_stands) {
    Scene scene = floor_scene({});
    scene.meshes.push_back(box({0.05F, 0.015F, 0.05F}, 0));
    Object block;
    block.mesh = 1;
    block.transform = glm::translate(glm::mat4(1), glm::vec3(0, 0.015F, 0));
    scene.objects.push_back(block);
    PointLight& light = scene.lights[0]; // as far and as wide as the sample's key light
    light.position = {-3, 3.5F, 0};
    light.intensity = glm::vec3(100);
    light.shadow_angle = 62;
    light.shadow_near = 1;
    light.shadow_far = 16;
    scene.orbit.distance = 0.5F;
    scene.orbit.elevation = 60;
    const auto bare = this->light(scene);
    light.casts_shadow = true;
    const auto pixels = this->light(scene, 1024);
    const ViewBlock view = view_block(scene.orbit, 1.5F);
    // The shadow behind the block is 26 mm long, four texels of the map.
    for (const float beyond : {0.008F, 0.014F}) {
        const glm::vec4 clip = view.clip * glm::vec4(0.05F + beyond, 0, 0, 1);
        const auto x = static_cast<std::size_t>((clip.x / clip.w * 0.5F + 0.5F) * size.width);
        const auto y = static_cast<std::size_t>((clip.y / clip.w * 0.5F + 0.5F) * size.height);
        const std::size_t at = (y * size.width + x) * 4;
        EXPECT_GT(bare[at], 0.1F);
        EXPECT_LT(pixels[at], 0.25F * bare[at]) << beyond;
    }
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
                const double sx = (x + 0.5) / size.width * 2 - 1;
                const double sy = (y + 0.5) / size.height * 2 - 1;
                const glm::dvec3 ray = glm::dvec3(view.forward) + sx * glm::dvec3(view.right) +
                                       sy * glm::dvec3(view.up);
                const glm::dvec3 eye(view.position_near);
                const glm::dvec3 at = eye - ray * (eye.y / ray.y);
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

class ResolveTest : public GpuTest {
  protected:
    struct Result {
        std::vector<float> texels;
        float maximum = 0;
    };
    Result resolve(const ImageDesc& desc, const std::vector<float>& texels, Size target,
                   float exposure) {
        const gpu::Image image = upload(desc, texels);
        Graph graph;
        const Resolved out =
            add_resolve(graph, graph.import("source", image, desc), target, exposure);
        graph.present(out.hdr);
        graph.present(out.maximum);
        Executor executor(device());
        executor.render(graph);
        Result result;
        result.texels = floats_of(as<std::uint16_t>(executor.read_image(out.hdr)));
        result.maximum = as<float>(executor.read_buffer(out.maximum)).front();
        return result;
    }
};

TEST_F(ResolveTest, everything_becomes_finite_and_the_maximum_is_exact) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> texels{nan, inf, -inf, 1,   -1, 0, 1e30F, 1, 0.5F, 1, 2, nan,
                                    4,   8,   -nan, inf, 3,  1, 1,     1, 7,    0, 0, 0};
    const Result result = resolve({Format::rgba32f, 3, 2}, texels, {3, 2}, 2);
    const std::vector<float> expected{0, 65504, 0, 1, 0, 0, 65504, 1, 1,  2, 4, 1,
                                      8, 16,    0, 1, 6, 2, 2,     1, 14, 0, 0, 1};
    EXPECT_EQ(result.texels, expected);
    EXPECT_EQ(result.maximum, 65504);
    EXPECT_EQ(resolve({Format::rgba32f, 1, 1}, {0.25F, 0.125F, 0, 1}, {1, 1}, 1).maximum, 0.25F);
    EXPECT_EQ(resolve({Format::rgba32f, 1, 1}, {0, -4, 0, 1}, {1, 1}, 1).maximum, 0);
}

TEST_F(ResolveTest, another_size_keeps_the_mean_and_ignores_what_is_not_finite) {
    const ImageDesc desc{Format::rgba32f, 12, 9};
    std::vector<float> texels;
    double mean = 0;
    for (std::uint32_t index = 0; index < desc.width * desc.height; ++index) {
        const auto value = static_cast<float>(index % 7);
        mean += static_cast<double>(value) / (desc.width * desc.height);
        texels.insert(texels.end(), {value, value, value, 1});
    }
    for (const Size target : {Size{4, 3}, Size{24, 18}, Size{6, 5}}) {
        const Result result = resolve(desc, texels, target, 1);
        double found = 0;
        for (std::size_t at = 0; at < result.texels.size(); at += 4) {
            found += static_cast<double>(result.texels[at]) / (target.width * target.height);
        }
        // Texels are rounded to halves, and where it is enlarged the border repeats.
        EXPECT_NEAR(found, mean, 0.05) << target.width;
    }
    texels[0] = std::numeric_limits<float>::quiet_NaN();
    for (const float value : resolve(desc, texels, {4, 3}, 1).texels) {
        EXPECT_TRUE(std::isfinite(value));
    }
}

TEST_F(ResolveTest, a_picture_keeps_its_proportions_between_black_bars) {
    const ImageDesc desc{Format::rgba32f, 4, 2};
    const std::vector<float> texels(std::size_t{4} * 4 * 2, 3);
    struct Case {
        Size target, low, high; ///< the picture from low to before high
    };
    for (const auto& [target, low, high] :
         {Case{{4, 6}, {0, 2}, {4, 4}}, Case{{9, 2}, {2, 0}, {6, 2}}, Case{{2, 7}, {0, 3}, {2, 4}},
          Case{{1, 1}, {0, 0}, {1, 1}}}) {
        const Result result = resolve(desc, texels, target, 1);
        for (std::uint32_t y = 0; y < target.height; ++y) {
            for (std::uint32_t x = 0; x < target.width; ++x) {
                const bool inside =
                    x >= low.width && x < high.width && y >= low.height && y < high.height;
                EXPECT_EQ(result.texels[std::size_t{4} * (y * target.width + x)], inside ? 3 : 0)
                    << target.width << "x" << target.height << ": " << x << "," << y;
            }
        }
    }
}

} // namespace
} // namespace preview
