#include "preview/scene/gltf_file.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace preview {

namespace {

using nlohmann::json;

void keep_only(json& object, std::initializer_list<std::string_view> keys) {
    for (auto row = object.begin(); row != object.end();) {
        row = std::find(keys.begin(), keys.end(), row.key()) != keys.end() ? std::next(row)
                                                                           : object.erase(row);
    }
}

/// The rows of a list, which check_gltf() has seen.
template <class F>
void each_row(json& object, const char* key, F f) {
    if (const auto rows = object.find(key); rows != object.end() && rows->is_array()) {
        for (json& row : *rows) {
            if (row.is_object()) {
                f(row);
            }
        }
    }
}

std::size_t rows_in(const json& object, const char* key) {
    const auto rows = object.find(key);
    return rows != object.end() && rows->is_array() ? rows->size() : 0;
}

void reduce_material(json& material, LeftOut& left_out) {
    for (const char* map : {"normalTexture", "occlusionTexture"}) {
        left_out.add("normal and occlusion textures", material.contains(map) ? 1 : 0);
    }
    left_out.add("transparency of materials",
                 material.value("alphaMode", json("OPAQUE")) != "OPAQUE" ? 1 : 0);
    const auto extensions = material.find("extensions");
    if (extensions != material.end() && extensions->is_object()) {
        for (const auto& [name, unused] : extensions->items()) {
            left_out.add("materials' " + name, name != "KHR_materials_emissive_strength" ? 1 : 0);
        }
    }
    keep_only(material,
              {"name", "pbrMetallicRoughness", "emissiveFactor", "emissiveTexture", "doubleSided"});
}

void reduce_primitive(json& primitive, LeftOut& left_out) {
    left_out.add("morph targets (the rest pose is shown)", rows_in(primitive, "targets"));
    left_out.add("vertex colours", primitive["attributes"].contains("COLOR_0") ? 1 : 0);
    keep_only(primitive, {"attributes", "indices", "material", "mode"});
    keep_only(primitive["attributes"], {"POSITION", "NORMAL"});
}

/// Whether it has triangles: as a list, a strip or a fan, of three corners at least.
bool has_triangles(const json& primitive, const json& accessors) {
    const json mode = primitive.value("mode", json(4));
    if (!primitive["attributes"].contains("POSITION") || (mode != 4 && mode != 5 && mode != 6)) {
        return false;
    }
    const json& corners =
        primitive.contains("indices") ? primitive["indices"] : primitive["attributes"]["POSITION"];
    return accessors[corners.get<std::size_t>()].value("count", json(0)) >= json(3);
}

void reduce_mesh(json& mesh, const json& root, LeftOut& left_out) {
    keep_only(mesh, {"name", "primitives"});
    json kept = json::array();
    each_row(mesh, "primitives", [&](json& primitive) {
        if (has_triangles(primitive, root["accessors"])) {
            reduce_primitive(primitive, left_out);
            kept.push_back(std::move(primitive));
        } else {
            left_out.add("meshes of points or lines");
        }
    });
    mesh["primitives"] = std::move(kept);
}

void reduce_node(json& node) {
    keep_only(node, {"name", "children", "matrix", "translation", "rotation", "scale", "mesh",
                     "camera", "extensions"});
    if (node.contains("extensions")) {
        keep_only(node["extensions"], {"KHR_lights_punctual"});
    }
}

/// A number of the object, or `usual`.
float fraction(const json& object, const char* pointer, float usual) {
    const json::json_pointer at(pointer);
    return object.contains(at) && object[at].is_number() ? object[at].get<float>() : usual;
}

} // namespace

GltfFacts facts_of(const json& root) {
    constexpr float most_emission = 65504;
    GltfFacts facts;
    if (root.contains("materials")) {
        for (const json& material : root["materials"]) {
            const float strength = fraction(
                material, "/extensions/KHR_materials_emissive_strength/emissiveStrength", 1);
            facts.emissive_strengths.push_back(strength >= 0 ? std::min(strength, most_emission)
                                                             : 1);
        }
    }
    if (root.contains("cameras")) {
        for (const json& camera : root["cameras"]) {
            facts.vertical_fields.push_back(fraction(camera, "/perspective/yfov", 0));
        }
    }
    return facts;
}

void reduce_gltf(json& root, LeftOut& left_out) {
    left_out.add("animations (the rest pose is shown)", rows_in(root, "animations"));
    left_out.add("skins (the rest pose is shown)", rows_in(root, "skins"));
    keep_only(root,
              {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers",
               "materials", "textures", "images", "cameras", "extensions", "extensionsUsed"});
    if (root.contains("extensions")) {
        keep_only(root["extensions"], {"KHR_lights_punctual"});
    }
    each_row(root, "materials", [&](json& material) { reduce_material(material, left_out); });
    each_row(root, "meshes", [&](json& mesh) { reduce_mesh(mesh, root, left_out); });
    each_row(root, "nodes", [](json& node) { reduce_node(node); });
}

} // namespace preview
