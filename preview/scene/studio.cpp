// The studio: a still life in a photographer's cove, made to judge a grade by. From left to
// right a ColorChecker, a knot of polished copper in a neon ring, balls from polished to rough in
// metal and in plastic, a pyramid of saturated blocks; in front a grey ramp and a ramp of skin
// tones. A warm key light and the spark, a very small and very bright source, cast shadows.
#include "preview/scene/builtin.h"
#include "preview/scene/swatches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preview {

namespace {

// The things that move, by what the builder made of them.
struct Moving {
    std::uint32_t knot, spark, spark_light;
};

constexpr glm::vec3 spark_rest{1.02F, 1.62F, -0.35F};
constexpr glm::vec3 knot_rest{0.22F, 0.74F, -0.75F};

glm::mat4 knot_transform(double seconds) {
    const auto degrees = static_cast<float>(std::fmod(seconds * 24, 360.0));
    glm::mat4 m = turned(at(knot_rest), 78, {1, 0, 0});
    return turned(m, degrees, {0, 1, 0}) * at({0, 0, 0}, glm::vec3{0.36F});
}

glm::vec3 spark_position(double seconds) {
    const double turn = 2 * std::numbers::pi * seconds / 12;
    return spark_rest + glm::vec3{static_cast<float>(0.35 * std::sin(turn)),
                                  static_cast<float>(0.12 * std::sin(2 * turn)),
                                  static_cast<float>(0.35 * (1 - std::cos(turn)))};
}

void add_cove(SceneBuilder& build) {
    std::vector<glm::vec2> profile{{8, 0}};
    for (int i = 0; i <= 16; ++i) {
        const float angle = std::numbers::pi_v<float> / 2 * static_cast<float>(i) / 16;
        profile.push_back({-1.6F - 1.4F * std::sin(angle), 1.4F * (1 - std::cos(angle))});
    }
    profile.push_back({-3, 7});
    const auto paper = build.material({linear_of(0x545c6a), 0.55F, 0, {}});
    build.place(build.mesh(extrude(profile, 11)), paper, glm::mat4{1}, false);
}

void add_color_checker(SceneBuilder& build) {
    constexpr float pitch = 0.2F;
    glm::mat4 card = turned(at({-1.42F, 0.52F, -0.12F}), 24, {0, 1, 0});
    card = turned(card, -7, {1, 0, 0});
    const auto board = build.mesh(box({pitch * 3.2F, pitch * 2.2F, 0.02F}, 0.015F));
    build.place(board, build.material({linear_of(0x18181a), 0.55F, 0, {}}), card);
    const auto patch = build.mesh(box({pitch * 0.43F, pitch * 0.43F, 0.012F}, 0.004F, 1));
    for (std::size_t i = 0; i < color_checker.size(); ++i) {
        const auto column = static_cast<float>(i % 6), row = static_cast<float>(i / 6);
        const glm::vec3 place{(column - 2.5F) * pitch, (1.5F - row) * pitch, 0.02F};
        build.place(patch, build.material({linear_of(color_checker[i]), 0.9F, 0, {}}),
                    card * at(place), false);
    }
    const auto foot = build.mesh(box({0.5F, 0.035F, 0.12F}, 0.02F, 2));
    build.place(foot, build.material({linear_of(0x18181a), 0.4F, 0, {}}),
                turned(at({-1.42F, 0.035F, -0.12F}), 24, {0, 1, 0}));
}

void add_ramps(SceneBuilder& build) {
    constexpr int greys = 12;
    const auto tile = build.mesh(box({0.094F, 0.02F, 0.075F}, 0.006F, 2));
    const auto row = [&](std::size_t i, std::size_t count, float z, float width) {
        const float x = (static_cast<float>(i) - 0.5F * static_cast<float>(count - 1)) * width;
        return at({x - 0.12F, 0.02F, z}, {width / 0.2F, 1, 1});
    };
    for (std::size_t i = 0; i < greys; ++i) {
        // Even steps of display code, black to white.
        const auto code = static_cast<std::uint32_t>(255.0 * static_cast<double>(i) / (greys - 1));
        const auto grey = build.material({linear_of(code * 0x010101u), 0.85F, 0, {}});
        build.place(tile, grey, row(i, greys, 1.42F, 0.2F));
    }
    for (std::size_t i = 0; i < skin_tones.size(); ++i) {
        build.place(tile, build.material({linear_of(skin_tones[i]), 0.55F, 0, {}}),
                    row(i, skin_tones.size(), 1.2F, 0.24F));
    }
}

void add_balls(SceneBuilder& build) {
    const auto ball = build.mesh(sphere(32, 64));
    constexpr int steps = 5;
    for (int i = 0; i < steps; ++i) {
        const float t = static_cast<float>(i) / (steps - 1);
        const float roughness = 0.08F + 0.62F * t;
        const auto metal = build.material({{1.0F, 0.71F, 0.29F}, roughness, 1, {}});
        const auto plastic = build.material({linear_of(0xb01e2e), roughness, 0, {}});
        build.place(ball, metal,
                    at({-0.62F + 0.42F * static_cast<float>(i), 0.17F, 0.32F}, glm::vec3{0.17F}));
        build.place(ball, plastic,
                    at({-0.44F + 0.42F * static_cast<float>(i), 0.12F, 0.76F}, glm::vec3{0.12F}));
    }
}

void add_blocks(SceneBuilder& build) {
    const auto block = build.mesh(box(glm::vec3{0.17F}, 0.025F, 3));
    struct Placed {
        std::uint32_t color;
        glm::vec3 position;
        float degrees;
    };
    constexpr Placed blocks[]{
        {0xe01818, {1.32F, 0.17F, 0.02F}, 14}, {0x18b028, {1.72F, 0.17F, -0.06F}, -6},
        {0x1830e0, {2.12F, 0.17F, 0.0F}, 20},  {0x10b8c8, {1.52F, 0.51F, -0.03F}, -10},
        {0xd020a8, {1.92F, 0.51F, -0.02F}, 8}, {0xf0d010, {1.71F, 0.85F, -0.02F}, 30},
    };
    for (const Placed& it : blocks) {
        build.place(block, build.material({linear_of(it.color), 0.38F, 0, {}}),
                    turned(at(it.position), it.degrees, {0, 1, 0}));
    }
}

Moving add_stage(SceneBuilder& build) {
    const auto plinth = build.mesh(cylinder(96));
    build.place(plinth, build.material({linear_of(0x2a2c31), 0.3F, 0, {}}),
                at({knot_rest.x, 0.06F, knot_rest.z}, {0.62F, 0.06F, 0.62F}));
    Moving moving{};
    const auto copper = build.material({{0.955F, 0.54F, 0.40F}, 0.19F, 1, {}});
    moving.knot =
        build.place(build.mesh(torus_knot(2, 3, 0.42F, 0.2F, 320, 28)), copper, knot_transform(0));

    const auto ring = build.mesh(torus(0.027F, 128, 16));
    const auto cyan = build.material({{0, 0, 0}, 1, 0, glm::vec3{0.35F, 3.4F, 4.6F}});
    build.place(ring, cyan,
                turned(at({knot_rest.x, 0.98F, -1.35F}), 90, {1, 0, 0}) *
                    at({0, 0, 0}, glm::vec3{0.86F}),
                false);
    const auto rod = build.mesh(box({0.02F, 0.62F, 0.02F}, 0.02F, 4));
    const auto magenta = build.material({{0, 0, 0}, 1, 0, glm::vec3{5.2F, 0.55F, 2.6F}});
    build.place(rod, magenta, turned(at({2.35F, 0.66F, -1.0F}), -14, {0, 0, 1}), false);

    const auto hot = build.material({{0, 0, 0}, 1, 0, glm::vec3{2600, 2300, 1900}});
    moving.spark =
        build.place(build.mesh(sphere(12, 24)), hot, at(spark_rest, glm::vec3{0.011F}), false);
    return moving;
}

// The same for every scene that shares the still life; the order of objects is the same too.
Moving add_still_life(SceneBuilder& build) {
    add_cove(build);
    const Moving moving = add_stage(build);
    add_color_checker(build);
    add_ramps(build);
    add_balls(build);
    add_blocks(build);
    build.scene.orbit = {{0.26F, 0.62F, -0.1F}, 6.3F, -5, 13, 27, 0.1F};
    return moving;
}

const Moving& moving_parts() {
    static const Moving moving = [] {
        SceneBuilder build;
        Moving found = add_still_life(build);
        found.spark_light = 1;
        return found;
    }();
    return moving;
}

} // namespace

Scene studio_scene() {
    SceneBuilder build;
    add_still_life(build);
    build.light({{-2.6F, 3.9F, 3.2F}, {104, 91, 73}, true, {0.2F, 0.3F, -0.2F}, 62, 1, 16, "key"});
    build.scene.lights.back().thickness = 0.3F; // a soft box
    build.light(
        {spark_rest, {3.4F, 2.9F, 2.2F}, true, {}, PointLight::all_round, 0.05F, 8, "spark"});
    PointLight ring;
    ring.position = {knot_rest.x, 0.98F, -1.35F};
    ring.intensity = {0.22F, 1.9F, 2.5F};
    ring.casts_shadow = true;
    ring.shape = PointLight::Shape::ring;
    ring.extent = {0, 0, 0.86F};
    ring.thickness = 0.023F;
    ring.shadow_angle = PointLight::all_round;
    ring.shadow_far = 8;
    ring.name = "ring";
    build.light(ring);
    PointLight rod;
    rod.position = {2.35F, 0.66F, -1.0F};
    rod.intensity = {2.6F, 0.26F, 1.3F};
    rod.casts_shadow = true;
    rod.shape = PointLight::Shape::rod;
    rod.extent = glm::vec3(turned(glm::mat4{1}, -14, {0, 0, 1}) * glm::vec4(0, 0.62F, 0, 0));
    rod.thickness = 0.02F;
    rod.shadow_angle = PointLight::all_round;
    rod.shadow_far = 8;
    rod.name = "rod";
    build.light(rod);
    build.scene.environment.zenith = {0.095F, 0.108F, 0.140F};
    build.scene.environment.horizon = {0.070F, 0.077F, 0.098F};
    build.scene.environment.ground = {0.036F, 0.035F, 0.038F};
    build.soft_box({-0.7F, 0.65F, 0.55F}, 26, {3.4F, 3.0F, 2.5F});
    build.soft_box({0.9F, 0.35F, 0.25F}, 40, {1.1F, 1.4F, 2.1F});
    build.soft_box({0.1F, 0.9F, -0.5F}, 24, {1.0F, 1.05F, 1.2F});
    build.scene.occlusion = 1;
    return std::move(build.scene);
}

Scene plain_scene() {
    SceneBuilder build;
    add_still_life(build);
    // No highlight reaches the brightness at which bloom begins.
    for (Material& material : build.scene.materials) {
        material.emission = glm::vec3{0};
        material.roughness = std::max(material.roughness, 0.65F);
    }
    build.light({{-2.6F, 3.9F, 3.2F}, {44, 41, 38}, false, {}, 60, 0.1F, 20, "key"});
    build.scene.environment.zenith = {0.20F, 0.21F, 0.23F};
    build.scene.environment.horizon = {0.11F, 0.11F, 0.12F};
    build.scene.environment.ground = {0.05F, 0.05F, 0.05F};
    return std::move(build.scene);
}

void animate_studio(Scene& scene, double seconds) {
    const Moving& moving = moving_parts();
    scene.objects[moving.knot].transform = knot_transform(seconds);
    const glm::vec3 spark = spark_position(seconds);
    scene.objects[moving.spark].transform = at(spark, glm::vec3{0.011F});
    if (moving.spark_light < scene.lights.size()) {
        scene.lights[moving.spark_light].position = spark;
    }
}

} // namespace preview
