// A model file as a scene: glTF 2.0 (.gltf, .glb) by a reader of our own, which checks what it
// uses, and Wavefront OBJ with its materials by Assimp, in a process of its own.
//
// Taken over of glTF: triangles (also sparse, quantized and skinned in the bind pose) with their
// nodes' transforms, metallic-roughness materials with textures and colours of vertices, cut-outs,
// unlit materials, cameras, point, spot and directional lights. What the renderer has nothing for
// is left out and told by its name.
//
// The scene is scaled and moved as one so that it is as large as the built-in one and stands in its
// place: shadow maps, near plane and sliders then suit it. A file without a camera is framed whole;
// one without lights gets the sample's key light, and every one gets the sample's surroundings.
// With lights of its own the exposure is such that a white sheet in the middle, turned to them,
// shows as 1.
#pragma once

#include "preview/scene/scene.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace preview {

struct ImportedScene {
    Scene scene;
    /// That it is made of: the model's own, then those that it names and may lead to, also what is
    /// not there.
    std::vector<std::string> files{};
    /// A line for each kind of thing left out or simplified, with its count. Printable whatever the
    /// file holds.
    std::vector<std::string> left_out;
};

/// Whether the name is a model file's, of these formats or of others.
bool is_model_file(const std::string& path);

/// Throws lutlib::Error, which names the file, for what is none of these formats, is broken, has
/// nothing to show, or is larger than import_limits.
ImportedScene import_scene(const std::string& path);

/// The bytes, at most `most`, of a file that the model names. Throws lutlib::Error.
using ReadFile = std::function<std::string(const std::string& reference, std::size_t most)>;

/// A glTF file that is in memory; `read` reads what lies beside it.
ImportedScene import_gltf(std::string_view bytes, const std::string& path, const ReadFile& read);

struct ImportLimits {
    std::size_t file_bytes = std::size_t{512} << 20U;
    std::size_t elements = 50'000'000; ///< of all accessors together, as often as they are read
    std::size_t json_values = 2'500'000;
    std::size_t nodes = 65'536;        ///< and objects, which are nodes times their meshes
    std::size_t vertices = 16'000'000; ///< of all meshes together, as drawn
    std::size_t lights = 16;
    std::size_t picture_side = 16'384;
    std::size_t texels = std::size_t{1} << 26U; ///< of all pictures together
    int depth = 64;                             ///< of the nodes' tree, and of the file's JSON
};
inline constexpr ImportLimits import_limits;

} // namespace preview
