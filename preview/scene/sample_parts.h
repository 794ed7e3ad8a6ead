// The parts of the sample scene, each put into the scene at its place. The table's top is y = 0.
#pragma once

#include "preview/scene/builtin.h"

namespace preview {

/// Where the window's light comes in: the wall x = plane, from low to high in y and z.
struct WindowFrame {
    float plane = -1.75F;
    float low_y = 0.3F, high_y = 1.95F;
    float low_z = -0.95F, high_z = 1.1F;
    glm::vec3 middle() const { return {plane, (low_y + high_y) / 2, (low_z + high_z) / 2}; }
};
inline constexpr WindowFrame sample_window;

void add_room(SceneBuilder& build);
void add_cloth(SceneBuilder& build);
void add_fruit(SceneBuilder& build);
void add_vessels(SceneBuilder& build);
void add_plant(SceneBuilder& build);
void add_skins(SceneBuilder& build);
void add_jewels(SceneBuilder& build);

/// A candle whose flame stands at `tip`; returns the flame.
std::uint32_t add_candle(SceneBuilder& build, glm::vec3 tip);

} // namespace preview
