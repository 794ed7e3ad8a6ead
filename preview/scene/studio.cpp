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

constexpr glm::vec3 spark_rest{1.02f, 1.62f, -0.35f};
constexpr glm::vec3 knot_rest{0.22f, 0.74f, -0.75f};

glm::mat4 knot_transform(double seconds) {
    const auto degrees = static_cast<float>(std::fmod(seconds * 24, 360.0));
    glm::mat4 m = turned(at(knot_rest), 78, {1, 0, 0});
    return turned(m, degrees, {0, 1, 0}) * at({0, 0, 0}, glm::vec3{0.36f});
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
        profile.push_back({-1.6f - 1.4f * std::sin(angle), 1.4f * (1 - std::cos(angle))});
    }
    profile.push_back({-3, 7});
    const auto paper = build.material({linear_of(0x545c6a), 0.55f, 0, {}});
    build.place(build.mesh(extrude(profile, 11)), paper, glm::mat4{1}, false);
}

void add_color_checker(SceneBuilder& build) {
    constexpr float pitch = 0.2f;
    glm::mat4 card = turned(at({-1.42f, 0.52f, -0.12f}), 24, {0, 1, 0});
    card = turned(card, -7, {1, 0, 0});
    const auto board = build.mesh(box({pitch * 3.2f, pitch * 2.2f, 0.02f}, 0.015f));
    build.place(board, build.material({linear_of(0x18181a), 0.55f, 0, {}}), card);
    const auto patch = build.mesh(box({pitch * 0.43f, pitch * 0.43f, 0.012f}, 0.004f, 1));
    for (std::size_t i = 0; i < color_checker.size(); ++i) {
        const auto column = static_cast<float>(i % 6), row = static_cast<float>(i / 6);
        const glm::vec3 place{(column - 2.5f) * pitch, (1.5f - row) * pitch, 0.02f};
        build.place(patch, build.material({linear_of(color_checker[i]), 0.9f, 0, {}}),
                    card * at(place), false);
    }
    const auto foot = build.mesh(box({0.5f, 0.035f, 0.12f}, 0.02f, 2));
    build.place(foot, build.material({linear_of(0x18181a), 0.4f, 0, {}}),
                turned(at({-1.42f, 0.035f, -0.12f}), 24, {0, 1, 0}));
}

void add_ramps(SceneBuilder& build) {
    constexpr int greys = 12;
    const auto tile = build.mesh(box({0.094f, 0.02f, 0.075f}, 0.006f, 2));
    const auto row = [&](std::size_t i, std::size_t count, float z, float width) {
        const float x = (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1)) * width;
        return at({x - 0.12f, 0.02f, z}, {width / 0.2f, 1, 1});
    };
    for (std::size_t i = 0; i < greys; ++i) {
        // Even steps of display code, black to white.
        const auto code = static_cast<std::uint32_t>(255.0 * static_cast<double>(i) / (greys - 1));
        const auto grey = build.material({linear_of(code * 0x010101u), 0.85f, 0, {}});
        build.place(tile, grey, row(i, greys, 1.42f, 0.2f));
    }
    for (std::size_t i = 0; i < skin_tones.size(); ++i) {
        build.place(tile, build.material({linear_of(skin_tones[i]), 0.55f, 0, {}}),
                    row(i, skin_tones.size(), 1.2f, 0.24f));
    }
}

void add_balls(SceneBuilder& build) {
    const auto ball = build.mesh(sphere(32, 64));
    constexpr int steps = 5;
    for (int i = 0; i < steps; ++i) {
        const float t = static_cast<float>(i) / (steps - 1);
        const float roughness = 0.08f + 0.62f * t;
        const auto metal = build.material({{1.0f, 0.71f, 0.29f}, roughness, 1, {}});
        const auto plastic = build.material({linear_of(0xb01e2e), roughness, 0, {}});
        build.place(ball, metal,
                    at({-0.62f + 0.42f * static_cast<float>(i), 0.17f, 0.32f}, glm::vec3{0.17f}));
        build.place(ball, plastic,
                    at({-0.44f + 0.42f * static_cast<float>(i), 0.12f, 0.76f}, glm::vec3{0.12f}));
    }
}

void add_blocks(SceneBuilder& build) {
    const auto block = build.mesh(box(glm::vec3{0.17f}, 0.025f, 3));
    struct Placed {
        std::uint32_t colour;
        glm::vec3 position;
        float degrees;
    };
    constexpr Placed blocks[]{
        {0xe01818, {1.32f, 0.17f, 0.02f}, 14}, {0x18b028, {1.72f, 0.17f, -0.06f}, -6},
        {0x1830e0, {2.12f, 0.17f, 0.0f}, 20},  {0x10b8c8, {1.52f, 0.51f, -0.03f}, -10},
        {0xd020a8, {1.92f, 0.51f, -0.02f}, 8}, {0xf0d010, {1.71f, 0.85f, -0.02f}, 30},
    };
    for (const Placed& it : blocks) {
        build.place(block, build.material({linear_of(it.colour), 0.38f, 0, {}}),
                    turned(at(it.position), it.degrees, {0, 1, 0}));
    }
}

Moving add_stage(SceneBuilder& build) {
    const auto plinth = build.mesh(cylinder(96));
    build.place(plinth, build.material({linear_of(0x2a2c31), 0.3f, 0, {}}),
                at({knot_rest.x, 0.06f, knot_rest.z}, {0.62f, 0.06f, 0.62f}));
    Moving moving{};
    const auto copper = build.material({{0.955f, 0.54f, 0.40f}, 0.19f, 1, {}});
    moving.knot =
        build.place(build.mesh(torus_knot(2, 3, 0.42f, 0.2f, 320, 28)), copper, knot_transform(0));

    const auto ring = build.mesh(torus(0.027f, 128, 16));
    const auto cyan = build.material({{0, 0, 0}, 1, 0, glm::vec3{0.35f, 3.4f, 4.6f}});
    build.place(ring, cyan,
                turned(at({knot_rest.x, 0.98f, -1.35f}), 90, {1, 0, 0}) *
                    at({0, 0, 0}, glm::vec3{0.86f}),
                false);
    const auto rod = build.mesh(box({0.02f, 0.62f, 0.02f}, 0.02f, 4));
    const auto magenta = build.material({{0, 0, 0}, 1, 0, glm::vec3{5.2f, 0.55f, 2.6f}});
    build.place(rod, magenta, turned(at({2.35f, 0.66f, -1.0f}), -14, {0, 0, 1}), false);

    const auto hot = build.material({{0, 0, 0}, 1, 0, glm::vec3{2600, 2300, 1900}});
    moving.spark =
        build.place(build.mesh(sphere(12, 24)), hot, at(spark_rest, glm::vec3{0.011f}), false);
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
    build.scene.orbit = {{0.26f, 0.62f, -0.1f}, 6.3f, -5, 13, 27, 0.1f};
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
    build.light({{-2.6f, 3.9f, 3.2f}, {104, 91, 73}, true, {0.2f, 0.3f, -0.2f}, 62, 1, 16, "key"});
    build.scene.lights.back().thickness = 0.3f; // a soft box
    build.light(
        {spark_rest, {3.4f, 2.9f, 2.2f}, true, {}, PointLight::all_round, 0.05f, 8, "spark"});
    PointLight ring;
    ring.position = {knot_rest.x, 0.98f, -1.35f};
    ring.intensity = {0.22f, 1.9f, 2.5f};
    ring.casts_shadow = true;
    ring.shape = PointLight::Shape::ring;
    ring.extent = {0, 0, 0.86f};
    ring.thickness = 0.023f;
    ring.shadow_angle = PointLight::all_round;
    ring.shadow_far = 8;
    ring.name = "ring";
    build.light(ring);
    PointLight rod;
    rod.position = {2.35f, 0.66f, -1.0f};
    rod.intensity = {2.6f, 0.26f, 1.3f};
    rod.casts_shadow = true;
    rod.shape = PointLight::Shape::rod;
    rod.extent = glm::vec3(turned(glm::mat4{1}, -14, {0, 0, 1}) * glm::vec4(0, 0.62f, 0, 0));
    rod.thickness = 0.02f;
    rod.shadow_angle = PointLight::all_round;
    rod.shadow_far = 8;
    rod.name = "rod";
    build.light(rod);
    build.scene.environment.zenith = {0.095f, 0.108f, 0.140f};
    build.scene.environment.horizon = {0.070f, 0.077f, 0.098f};
    build.scene.environment.ground = {0.036f, 0.035f, 0.038f};
    build.soft_box({-0.7f, 0.65f, 0.55f}, 26, {3.4f, 3.0f, 2.5f});
    build.soft_box({0.9f, 0.35f, 0.25f}, 40, {1.1f, 1.4f, 2.1f});
    build.soft_box({0.1f, 0.9f, -0.5f}, 24, {1.0f, 1.05f, 1.2f});
    build.scene.occlusion = 1;
    return std::move(build.scene);
}

Scene plain_scene() {
    SceneBuilder build;
    add_still_life(build);
    // No highlight reaches the brightness at which bloom begins.
    for (Material& material : build.scene.materials) {
        material.emission = glm::vec3{0};
        material.roughness = std::max(material.roughness, 0.65f);
    }
    build.light({{-2.6f, 3.9f, 3.2f}, {44, 41, 38}, false, {}, 60, 0.1f, 20, "key"});
    build.scene.environment.zenith = {0.20f, 0.21f, 0.23f};
    build.scene.environment.horizon = {0.11f, 0.11f, 0.12f};
    build.scene.environment.ground = {0.05f, 0.05f, 0.05f};
    return std::move(build.scene);
}

void animate_studio(Scene& scene, double seconds) {
    const Moving& moving = moving_parts();
    scene.objects[moving.knot].transform = knot_transform(seconds);
    const glm::vec3 spark = spark_position(seconds);
    scene.objects[moving.spark].transform = at(spark, glm::vec3{0.011f});
    if (moving.spark_light < scene.lights.size()) {
        scene.lights[moving.spark_light].position = spark;
    }
}

} // namespace preview
