// Shadow maps on a device, against rays.
#include "preview/reference/ggx.h"
#include "preview/reference/shadow.h"
#include "tests/preview/passes/lit_fixture.h"

#include <map>

namespace preview {
namespace {

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

TEST_F(GeometryTest, a_lit_floor_does_not_shadow_itself) {
    Scene scene = floor_scene({});
    const auto free_of_shadows = light(scene);
    scene.lights[0].casts_shadow = true;
    for (const ShadowFilter& row : shadow_filters()) {
        const auto pixels = light(scene, 512, false, row.name);
        for (std::size_t at = 0; at < pixels.size(); ++at) {
            ASSERT_EQ(pixels[at], free_of_shadows[at]) << row.name << ' ' << at;
        }
    }
}

TEST_F(GeometryTest, the_edge_of_a_shadow_is_as_wide_as_its_filter) {
    Scene scene = floor_scene({});
    scene.meshes.push_back(box({1, 0.01F, 1}, 0));
    Object sheet;
    sheet.mesh = 1;
    sheet.transform = glm::translate(glm::mat4(1), glm::vec3(-0.6F, 1, -0.4F));
    scene.objects.push_back(sheet);
    PointLight& lamp = scene.lights[0];
    const auto bare = light(scene);
    lamp.casts_shadow = true;
    lamp.aim = {0.7F, 0, -0.4F}; // straight down, so that texels lie along the axes
    constexpr std::uint32_t map_size = 48;
    const double texel = 2 * std::tan(glm::radians(50.0)) / map_size * 2; // on the floor
    const ViewBlock view = view_block(scene.orbit, 1.5F);
    std::map<std::string_view, double> width, middle;
    for (const ShadowFilter& row : shadow_filters()) {
        const auto pixels = light(scene, map_size, false, row.name);
        double between = 0, least = 1e9, most = -1e9;
        for (std::uint32_t y = 0; y < size.height; ++y) {
            for (std::uint32_t x = 0; x < size.width; ++x) {
                glm::dvec3 ray;
                const glm::dvec3 at = on_floor(view, x, y, ray);
                const std::size_t index = (std::size_t{y} * size.width + x) * 4;
                // The sheet's edge at x = 0.4 falls on x = 0.1, its upper side alone.
                if (ray.y >= 0 || std::abs(at.z - 0.5) > 0.4 || std::abs(at.x - 0.1) > 1 ||
                    bare[index] <= 0) {
                    continue;
                }
                const double share =
                    static_cast<double>(pixels[index]) / static_cast<double>(bare[index]);
                if (share > 0.02 && share < 0.98) {
                    least = std::min(least, at.x);
                    most = std::max(most, at.x);
                    ++between;
                }
            }
        }
        ASSERT_GT(between, 5) << row.name;
        width[row.name] = (most - least) / texel;
        middle[row.name] = (most + least) / 2;
        EXPECT_NEAR(middle[row.name], 0.1, 1.2 * texel) << row.name;
    }
    // A square of n texels makes a ramp n texels wide, but for the pixels that see it.
    EXPECT_NEAR(width["1x1"], 1, 0.8);
    EXPECT_NEAR(width["3x3"], 3, 0.8);
    EXPECT_NEAR(width["5x5"], 5, 0.8);
    EXPECT_NEAR(width["disc"], 5, 1.2);
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
    struct Case {
        float angle;
        const char* filter;
    };
    for (const auto& [angle, filter] : {Case{PointLight::all_round, "3x3"},
                                        {140, "3x3"},
                                        {PointLight::all_round, "1x1"},
                                        {140, "1x1"}}) {
        const bool is_aimed = angle < 180;
        const std::uint32_t map_size = is_aimed ? 512 : 256;
        light.casts_shadow = false;
        const auto bare = this->light(scene, map_size);
        light.casts_shadow = true;
        light.shadow_angle = angle;
        light.aim = {0.15F, 0, -0.1F};
        const auto pixels = this->light(scene, map_size, false, filter);
        const reference::Casters casters(scene);
        const ViewBlock view = view_block(scene.orbit, 1.5F);
        const glm::dvec3 source(light.position);
        int lit = 0, dark = 0, wrong = 0;
        for (std::uint32_t y = 0; y < size.height; y += 2) {
            for (std::uint32_t x = 0; x < size.width; x += 2) {
                glm::dvec3 ray;
                const glm::dvec3 at = on_floor(view, x, y, ray);
                const glm::dvec3 eye(view.position_near);
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
        EXPECT_EQ(wrong, 0) << angle << ' ' << filter << ": of " << lit << " lit and " << dark
                            << " dark";
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

} // namespace
} // namespace preview
