// Two studies: spheres over roughness and metalness, and a chart of exact values.
#include "preview/scene/builtin.h"
#include "preview/scene/swatches.h"

namespace preview {

Scene materials_scene() {
    SceneBuilder build;
    const auto ball = build.mesh(sphere(48, 96));
    constexpr int columns = 7, rows = 4;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const float metalness = static_cast<float>(row) / (rows - 1);
            const float roughness = static_cast<float>(column) / (columns - 1);
            const auto paint = build.material({{0.8f, 0.45f, 0.25f}, roughness, metalness, {}});
            build.place(ball, paint,
                        at({static_cast<float>(column) - 3, 1.5f - static_cast<float>(row), 0},
                           glm::vec3{0.44f}));
        }
    }
    build.light({{-4, 5, 6}, {130, 125, 115}, true, {0, 0, 0}, 60, 1, 20, "key"});
    build.light({{5, -1, 5}, {14, 16, 22}, false, {}, 60, 0.1f, 20, "fill"});
    build.scene.environment.zenith = {0.30f, 0.33f, 0.40f};
    build.scene.environment.horizon = {0.12f, 0.12f, 0.13f};
    build.scene.environment.ground = {0.04f, 0.035f, 0.03f};
    build.soft_box({-0.5f, 0.6f, 0.6f}, 60, {2.5f, 2.4f, 2.2f});
    build.soft_box({0.8f, 0.1f, 0.5f}, 90, {0.8f, 1.0f, 1.4f});
    build.scene.orbit = {{0, 0, 0}, 9.6f, 0, 0, 27, 0.1f};
    return std::move(build.scene);
}

Scene chart_scene() {
    SceneBuilder build;
    const auto tile = build.mesh(box({0.47f, 0.47f, 0.01f}, 0));
    const auto add = [&](const Swatch& swatch, float x, float y, glm::vec3 scale) {
        const auto paint = build.material({{0, 0, 0}, 1, 0, linear_of(swatch)});
        build.place(tile, paint, at({x, y, 0}, scale), false);
    };
    for (std::size_t i = 0; i < color_checker.size(); ++i) {
        add(color_checker[i], static_cast<float>(i % 6) - 2.5f, 2.1f - static_cast<float>(i / 6),
            glm::vec3{1});
    }
    for (std::size_t i = 0; i < skin_tones.size(); ++i) {
        add(skin_tones[i], 0.6f * (static_cast<float>(i) - 4.5f), -2.0f, {0.6f, 0.9f, 1});
    }
    build.scene.orbit = {{0, 0, 0}, 9.6f, 0, 0, 32, 0.1f};
    return std::move(build.scene);
}

} // namespace preview
