// Textures read in double from the pictures themselves. Twin of shaders/common/texture.glsl.
#pragma once

#include "preview/scene/scene.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace preview::reference {

/// Linear. `dx` and `dy` are the changes of `uv` to the pixels beside.
glm::dvec4 texture_at(const Scene& scene, const Texture& texture, glm::dvec2 uv, glm::dvec2 dx,
                      glm::dvec2 dy);

/// A material's texture at texture coordinates; white where it has none.
glm::dvec4 texture_at(const Scene& scene, const TextureUse& use, glm::dvec2 uv, glm::dvec2 dx,
                      glm::dvec2 dy);

} // namespace preview::reference
