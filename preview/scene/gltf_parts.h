// The parts of import_gltf().
#pragma once

#include "preview/scene/gltf_file.h"
#include "preview/scene/import_parts.h"

#include <utility>

namespace preview {

/// Every node's place in the file's world, by number.
std::vector<glm::mat4> gltf_places(const GltfFile& file, LeftOut& left_out);

/// The nodes of the file's scene, above before below.
std::vector<std::size_t> gltf_shown_nodes(const GltfFile& file);

/// A material, and how the scene's texture coordinates are taken from the file's.
struct GltfMaterial {
    Material material;
    std::size_t uv_sets[2]{0, 1};
    bool is_double_sided = false;
};

/// The materials in order, then the one of meshes that name none. Adds pictures and textures.
std::vector<GltfMaterial> gltf_materials(const GltfFile& file, Scene& scene, LeftOut& left_out);

/// Meshes and the objects that show them.
void gltf_meshes(const GltfFile& file, const std::vector<GltfMaterial>& materials,
                 const std::vector<glm::mat4>& places, Scene& scene, LeftOut& left_out);

/// Counts the extensions that the object uses and this import does not know.
void gltf_extensions(const nlohmann::json& object, const std::string& of,
                     std::initializer_list<std::string_view> known, LeftOut& left_out);

} // namespace preview
