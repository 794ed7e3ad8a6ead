// The built-in scenes that the table in scene.cpp lists, and the parts they are put together from.
#pragma once

#include "preview/scene/scene.h"

namespace preview {

Scene sample_scene();
void animate_sample(Scene& scene, double seconds);
Scene studio_scene();
Scene plain_scene();
void animate_studio(Scene& scene, double seconds);
Scene night_scene();
Scene exterior_scene();
Scene materials_scene();
Scene chart_scene();

/// Adds things to a scene and returns their indices.
class SceneBuilder {
  public:
    std::uint32_t mesh(Mesh mesh);
    std::uint32_t material(const Material& material);
    std::uint32_t place(std::uint32_t mesh, std::uint32_t material, const glm::mat4& transform,
                        bool casts_shadow = true);
    /// Of a picture of its own.
    std::uint32_t texture(Picture picture, bool is_color, Wrap wrap = Wrap::repeat);
    void light(const PointLight& light) { scene.lights.push_back(light); }
    void soft_box(glm::vec3 towards, float sharpness, glm::vec3 radiance);

    Scene scene;
};

glm::mat4 at(glm::vec3 position, glm::vec3 scale = glm::vec3{1});
glm::mat4 turned(glm::mat4 transform, float degrees, glm::vec3 axis);

} // namespace preview
