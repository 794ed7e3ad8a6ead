// A glTF 2.0 file (.gltf, .glb) as a scene.
//
// Taken over: triangles with their nodes' transforms, the factors of metallic-roughness materials,
// the first perspective camera, point, spot and directional lights. A texture stands as its mean,
// times the factor. What the renderer has nothing for is left out and told.
//
// The scene is scaled and moved as one so that it is as large as the built-in one and stands in its
// place: shadow maps, near plane and sliders then suit it. A file without a camera is framed whole;
// one without lights gets the sample's key light, and every one gets the sample's surroundings.
// With lights of its own the exposure is such that a white sheet in the middle, turned to them,
// shows as 1.
#pragma once

#include "preview/scene/scene.h"

#include <string>
#include <vector>

namespace preview {

struct ImportedScene {
    Scene scene;
    /// A line for each kind of thing left out or simplified, with its count.
    std::vector<std::string> left_out;
};

/// Whether the name is a model file's.
bool is_model_file(const std::string& path);

/// Throws lutlib::Error, which names the file, for what is no glTF 2.0, is broken, has nothing to
/// show, or is larger than import_limits.
ImportedScene import_scene(const std::string& path);

struct ImportLimits {
    std::size_t file_bytes = std::size_t{512} << 20U;
    std::size_t elements = 50'000'000; ///< of all accessors together
    std::size_t nodes = 65'536;        ///< and objects, which are nodes times their meshes
    std::size_t vertices = 16'000'000; ///< of all meshes together, as drawn
    std::size_t lights = 16;
    int depth = 64; ///< of the nodes' tree, and of the file's JSON
};
inline constexpr ImportLimits import_limits;

} // namespace preview
