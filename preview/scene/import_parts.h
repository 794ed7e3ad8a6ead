// The parts of import_scene().
#pragma once

#include "preview/scene/import.h"

#include <assimp/material.h>
#include <assimp/matrix4x4.h>

#include <glm/mat4x4.hpp>
#include <map>

struct aiScene;

namespace preview {

/// What is left out, counted.
class LeftOut {
  public:
    void add(const std::string& what, std::size_t count = 1) {
        if (count > 0) {
            counts_[what] += count;
        }
    }
    std::vector<std::string> lines() const;

  private:
    std::map<std::string, std::size_t> counts_;
};

/// What Assimp 5.2 does not read, or not as glTF means it.
struct GltfFacts {
    std::vector<float> emissive_strengths; ///< of materials
    std::vector<float> vertical_fields;    ///< of view of cameras, radians; 0: not perspective
};

/// Its factors, and the means of its textures. Emission is of strength 1.
Material import_material(const aiScene& scene, const aiMaterial& material,
                         const std::string& folder, LeftOut& left_out);

/// A named place in the file's world.
using Places = std::map<std::string, glm::mat4>;

/// Camera and lights of the file, or stand-ins, with surroundings and exposure; `fit` carries the
/// file's world to the scene's.
void import_view(const aiScene& file, const GltfFacts& facts, const Places& nodes,
                 const glm::mat4& fit, Scene& scene, LeftOut& left_out);

} // namespace preview
