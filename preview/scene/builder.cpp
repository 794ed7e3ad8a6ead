#include "preview/scene/builtin.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace preview {

std::uint32_t SceneBuilder::mesh(Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(scene.meshes.size() - 1);
}

std::uint32_t SceneBuilder::material(const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t SceneBuilder::place(std::uint32_t mesh, std::uint32_t material,
                                  const glm::mat4& transform, bool casts_shadow) {
    scene.objects.push_back({mesh, material, transform, casts_shadow});
    return static_cast<std::uint32_t>(scene.objects.size() - 1);
}

std::uint32_t SceneBuilder::texture(Picture picture, bool is_color, Wrap wrap) {
    scene.pictures.push_back(std::move(picture));
    Texture texture;
    texture.picture = static_cast<std::uint32_t>(scene.pictures.size() - 1);
    texture.is_color = is_color;
    texture.wrap_u = texture.wrap_v = wrap;
    scene.textures.push_back(texture);
    return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

void SceneBuilder::soft_box(glm::vec3 towards, float sharpness, glm::vec3 radiance) {
    Environment& environment = scene.environment;
    environment.soft_boxes[environment.soft_box_count++] = {glm::normalize(towards), sharpness,
                                                            radiance};
}

glm::mat4 at(glm::vec3 position, glm::vec3 scale) {
    return glm::scale(glm::translate(glm::mat4{1}, position), scale);
}

glm::mat4 turned(glm::mat4 transform, float degrees, glm::vec3 axis) {
    return glm::rotate(transform, glm::radians(degrees), axis);
}

} // namespace preview
