// Any bytes as a .gltf or .glb with nothing beside it: a scene that can be drawn, or an Error.
#include "lutlib/error.h"
#include "preview/scene/import.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto nothing = [](const std::string& path, std::size_t) -> std::string {
        throw lutlib::Error("there is nothing beside it", {path, 0, {}});
    };
    preview::ImportedScene imported;
    try {
        imported = preview::import_gltf(bytes, "fuzz.gltf", nothing);
    } catch (const lutlib::Error&) {
        return 0;
    }
    const preview::Scene& scene = imported.scene;
    const auto hold = [](bool is_true) {
        if (!is_true) {
            std::abort();
        }
    };
    for (const preview::Mesh& mesh : scene.meshes) {
        hold(mesh.details.empty() || mesh.details.size() == mesh.vertices.size());
        for (const std::uint32_t index : mesh.indices) {
            hold(index < mesh.vertices.size());
        }
    }
    for (const preview::Object& object : scene.objects) {
        hold(object.mesh < scene.meshes.size() && object.material < scene.materials.size());
    }
    for (const preview::Texture& texture : scene.textures) {
        hold(texture.picture < scene.pictures.size());
    }
    hold(std::isfinite(scene.orbit.distance) && std::isfinite(scene.exposure));
    for (const std::string& line : imported.left_out) {
        hold(line.find('\x1b') == std::string::npos);
    }
    return 0;
}
