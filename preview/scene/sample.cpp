// The sample scene: a still life by a window, made to judge a grade by. The sun falls through the
// bars onto wood, linen, glazed and brushed things, fruit, leaves, measured skins, black glass and
// velvet; the sky fills the shadows with blue; a candle stands for lamps.
#include "preview/scene/sample_parts.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace preview {

namespace {

constexpr glm::vec3 flame_tip{1.62F, 0.66F, -0.98F};
constexpr glm::vec3 candle_intensity{0.5F, 0.245F, 0.088F};

/// How far the flame leans, and how bright it is about 1: slow waves that never quite repeat.
struct Flicker {
    float lean, light;
};

Flicker flicker_at(double seconds) {
    const auto wave = [&](double hertz) {
        return static_cast<float>(std::sin(2 * std::numbers::pi * hertz * seconds));
    };
    return {6 * wave(0.7) + 3 * wave(1.9), 1 + 0.08F * wave(1.3) + 0.05F * wave(3.1)};
}

struct Moving {
    std::uint32_t flame;
};

Moving add_things(SceneBuilder& build) {
    // What stands in front is drawn first, for what it hides costs nothing then.
    add_skins(build);
    add_jewels(build);
    add_fruit(build);
    add_vessels(build);
    add_plant(build);
    const Moving moving{add_candle(build, flame_tip)};
    add_cloth(build);
    add_room(build);
    return moving;
}

const Moving& moving_parts() {
    static const Moving moving = [] {
        SceneBuilder build;
        return add_things(build);
    }();
    return moving;
}

void add_lights(SceneBuilder& build) {
    const glm::vec3 window = sample_window.middle();
    const glm::vec3 from = window - 7.0F * glm::normalize(glm::vec3(1, -0.5F, -0.2F));
    PointLight sun{from, {1400, 1130, 790}, true, window, 27, 5, 14, "sun"};
    sun.axis = glm::normalize(window - from);
    sun.inner_angle = 13.3F;
    sun.outer_angle = 13.4F;
    build.light(sun);
    // The sky through the window's upper and lower half.
    build.light(
        {{-1.6F, 1.5F, 0.35F}, {1.7F, 2.05F, 2.6F}, true, {0.3F, 0.1F, 0}, 130, 0.1F, 8, "sky"});
    build.light({{-1.6F, 0.85F, -0.3F},
                 {0.9F, 1.1F, 1.35F},
                 true,
                 {0.5F, 0.2F, 0},
                 130,
                 0.1F,
                 8,
                 "low-sky"});
    build.light({flame_tip + glm::vec3(0, 0.03F, 0.02F),
                 candle_intensity,
                 false,
                 {},
                 60,
                 0.1F,
                 20,
                 "candle"});
}

} // namespace

Scene sample_scene() {
    SceneBuilder build;
    add_things(build);
    add_lights(build);
    build.scene.environment.zenith = {0.075F, 0.078F, 0.085F};
    build.scene.environment.horizon = {0.060F, 0.058F, 0.056F};
    build.scene.environment.ground = {0.105F, 0.080F, 0.056F};
    build.soft_box({-1, 0.5F, 0.25F}, 22, {1.35F, 1.5F, 1.75F});
    build.soft_box({0.9F, 0.5F, 0.5F}, 22, {0.4F, 0.35F, 0.28F});
    build.scene.exposure = 0.15F;
    build.scene.occlusion = 1;
    build.scene.shadow_size = 2048; // the sun grazes the wall, which draws texels out
    build.scene.orbit = {{0.12F, 0.4F, -0.2F}, 4.2F, 11, 12, 27, 0.1F};
    return std::move(build.scene);
}

void animate_sample(Scene& scene, double seconds) {
    const Flicker flicker = flicker_at(seconds);
    scene.objects[moving_parts().flame].transform =
        turned(at(flame_tip), flicker.lean, {0, 0, 1}) * at({0, 0, 0}, glm::vec3(0.022F));
    scene.lights.back().intensity = flicker.light * candle_intensity;
}

} // namespace preview
