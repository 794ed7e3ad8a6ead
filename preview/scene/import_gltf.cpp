#include "lutlib/json_text.h"
#include "preview/scene/gltf_parts.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

namespace preview {

namespace {

using nlohmann::json;

/// Nothing for one that sees nothing: it is left out.
std::optional<FileCamera> camera_of(const json& given, const glm::mat4& place, LeftOut& left_out) {
    FileCamera out;
    out.name = printable(gltf_text(given, "name"));
    out.place = place;
    if (gltf_text(given, "type") == "orthographic") {
        out.half_height = gltf_number(gltf_object(given, "orthographic"), "ymag", 1);
        if (out.half_height == 0) {
            left_out.add("orthographic cameras whose ymag is 0");
            return std::nullopt;
        }
    } else {
        constexpr float usual = 0.7F, least = 0.01F, most = 3;
        const float field = gltf_number(gltf_object(given, "perspective"), "yfov", usual);
        if (!(field > 0 && field < std::numbers::pi_v<float>)) {
            left_out.add("perspective cameras whose yfov is not between 0 and 3.1416");
            return std::nullopt;
        }
        out.vertical_field = std::clamp(field, least, most);
    }
    return out;
}

FileLight light_of(const json& given, const glm::mat4& place) {
    FileLight out;
    out.name = printable(gltf_text(given, "name"));
    out.place = place;
    const std::string type = gltf_text(given, "type");
    out.kind = type == "directional" ? FileLight::Kind::sun
               : type == "spot"      ? FileLight::Kind::spot
                                     : FileLight::Kind::point;
    float color[3] = {1, 1, 1};
    gltf_numbers(given, "color", color, 3);
    const float intensity = std::max(gltf_number(given, "intensity", 1), 0.0F);
    for (int c = 0; c < 3; ++c) {
        out.intensity[c] = std::max(color[c], 0.0F) * intensity;
    }
    out.range = std::max(gltf_number(given, "range", 0), 0.0F);
    const json& spot = gltf_object(given, "spot");
    constexpr float widest = std::numbers::pi_v<float> / 2;
    out.outer_angle = std::clamp(gltf_number(spot, "outerConeAngle", widest / 2), 0.0F, widest);
    out.inner_angle = std::clamp(gltf_number(spot, "innerConeAngle", 0), 0.0F, out.outer_angle);
    return out;
}

/// Cameras and lights of the nodes that are shown.
void read_view(const GltfFile& file, const std::vector<glm::mat4>& places, FileScene& out,
               LeftOut& left_out) {
    constexpr const char* punctual = "KHR_lights_punctual";
    const json& lights =
        file.list(gltf_object(gltf_object(file.root(), "extensions"), punctual), "lights");
    for (const std::size_t node : gltf_shown_nodes(file)) {
        const json& row = file.list("nodes")[node];
        if (const auto camera = file.index(row, "camera", "cameras")) {
            auto seen = camera_of(file.list("cameras")[*camera], places[node], left_out);
            if (seen && seen->name.empty()) {
                seen->name = printable(gltf_text(row, "name"));
            }
            if (seen) {
                out.cameras.push_back(std::move(*seen));
            }
        }
        const json& light = gltf_object(gltf_object(row, "extensions"), punctual);
        if (!light.contains("light")) {
            continue;
        }
        const std::size_t number = file.count(light, "light", 0);
        if (number >= lights.size()) {
            file.refuse("a node names a light that does not exist");
        }
        if (out.lights.size() == import_limits.lights) {
            left_out.add("lights beyond the first " + std::to_string(import_limits.lights));
            continue;
        }
        out.lights.push_back(light_of(lights[number], places[node]));
    }
}

constexpr std::string_view known_extensions[] = {
    "KHR_lights_punctual",   "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform",
};

/// Refuses a file that has no triangles without an extension that is not known.
void check_required(const GltfFile& file, LeftOut& left_out) {
    const auto required = file.root().find("extensionsRequired");
    if (required == file.root().end() || !required->is_array()) {
        return;
    }
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
        if (std::find(required->begin(), required->end(), name) != required->end()) {
            file.refuse(std::string("its meshes are compressed (") + name +
                        "); convert it to plain glTF 2.0");
        }
    }
    for (const json& name : *required) {
        if (name.is_string() && std::find(std::begin(known_extensions), std::end(known_extensions),
                                          name.get<std::string>()) == std::end(known_extensions)) {
            left_out.add("extensions that the file requires: " +
                         printable(name.get<std::string>()));
        }
    }
}

void tell_extensions(const GltfFile& file, LeftOut& left_out) {
    gltf_extensions(file.root(), "the file's", {"KHR_lights_punctual"}, left_out);
    left_out.add("animations (the rest pose is shown)", file.list("animations").size());
}

} // namespace

ImportedScene import_gltf(std::string_view bytes, const std::string& path, const ReadFile& read) {
    LeftOut left_out;
    const GltfFile file(bytes, path, read);
    FileScene out;
    try {
        check_required(file, left_out);
        tell_extensions(file, left_out);
        const std::vector<GltfMaterial> materials = gltf_materials(file, out.scene, left_out);
        const std::vector<glm::mat4> places = gltf_places(file, left_out);
        gltf_meshes(file, materials, places, out.scene, left_out);
        for (const GltfMaterial& material : materials) {
            out.scene.materials.push_back(material.material);
        }
        read_view(file, places, out, left_out);
    } catch (const json::exception& error) {
        file.refuse("not a usable glTF file: " + printable(lutlib::json_reason(error)));
    }
    ImportedScene imported;
    imported.scene = settled(std::move(out), path, left_out);
    imported.left_out = left_out.lines();
    return imported;
}

} // namespace preview
