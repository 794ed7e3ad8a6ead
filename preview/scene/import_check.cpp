#include "preview/scene/import_parts.h"

#include "lutlib/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstring>

namespace preview {

namespace {

using lutlib::Error;
using nlohmann::json;

/// The JSON of a .glb: a header of 12 bytes, then chunks of length, type and contents.
std::string_view json_of_binary(std::string_view bytes, const std::string& path) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    };
    constexpr std::uint32_t json_chunk = 0x4E4F534A;
    if (bytes.size() < 20 || word(8) > bytes.size() || word(16) != json_chunk ||
        word(12) > bytes.size() - 20)
        throw Error("the file is cut short, or no binary glTF", {path, 0, {}});
    return bytes.substr(20, word(12));
}

json parsed(const std::string& bytes, const std::string& path) {
    const bool binary = bytes.compare(0, 4, "glTF") == 0;
    const std::string_view text = binary ? json_of_binary(bytes, path) : std::string_view(bytes);
    const auto limit_depth = [&](int depth, json::parse_event_t, json&) {
        if (depth > import_limits.depth)
            throw Error("its JSON is nested too deeply", {path, 0, {}});
        return true;
    };
    try {
        return json::parse(text, limit_depth);
    } catch (const json::exception& error) {
        throw Error(fmt::format("it is no glTF, whose parts are JSON: {}", error.what()),
                    {path, 0, {}});
    }
}

/// A number that counts or points to something; `usual` where there is none.
std::size_t number(const json& object, const char* key, std::size_t usual,
                   const std::string& path) {
    const auto found = object.find(key);
    if (found == object.end())
        return usual;
    if (!found->is_number_unsigned())
        throw Error(fmt::format("'{}' is no count or number of something", key),
                    {path, 0, found->dump().substr(0, 80)});
    return found->get<std::size_t>();
}

/// An array of objects, or nothing.
const json& list(const json& object, const char* key, const std::string& path) {
    static const json none = json::array();
    const auto found = object.find(key);
    if (found == object.end())
        return none;
    if (!found->is_array())
        throw Error(fmt::format("'{}' is no list", key), {path, 0, {}});
    for (const json& row : *found)
        if (!row.is_object())
            throw Error(fmt::format("'{}' holds something that is no object", key), {path, 0, {}});
    return *found;
}

std::size_t component_bytes(std::size_t type) {
    return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
}

std::size_t component_count(const std::string& type) {
    constexpr std::pair<std::string_view, std::size_t> counts[] = {
        {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : counts)
        if (type == name)
            return count;
    return 1;
}

/// Every range lies within what holds it.
void check_ranges(const json& root, const std::string& path) {
    const json& buffers = list(root, "buffers", path);
    const json& views = list(root, "bufferViews", path);
    for (const json& view : views) {
        const std::size_t buffer = number(view, "buffer", 0, path);
        const std::size_t whole =
            buffer < buffers.size() ? number(buffers[buffer], "byteLength", 0, path) : 0;
        const std::size_t length = number(view, "byteLength", 0, path);
        if (length > whole || number(view, "byteOffset", 0, path) > whole - length)
            throw Error("a bufferView reaches beyond its buffer", {path, 0, {}});
    }
    std::size_t elements = 0;
    for (const json& accessor : list(root, "accessors", path)) {
        const std::size_t count = number(accessor, "count", 0, path);
        elements += std::min(count, import_limits.elements + 1);
        if (elements > import_limits.elements)
            throw Error(fmt::format("its accessors hold more than {} elements, which is the limit",
                                    import_limits.elements),
                        {path, 0, {}});
        if (accessor.contains("sparse"))
            throw Error("it has sparse accessors; convert it to plain ones", {path, 0, {}});
        if (accessor.find("bufferView") == accessor.end() || count == 0)
            continue;
        const std::size_t index = number(accessor, "bufferView", 0, path);
        if (index >= views.size())
            throw Error("an accessor names a bufferView that is not there", {path, 0, {}});
        const std::size_t size = component_bytes(number(accessor, "componentType", 0, path)) *
                                 component_count(accessor.value("type", json()).is_string()
                                                     ? accessor["type"].get<std::string>()
                                                     : std::string());
        const std::size_t stride = number(views[index], "byteStride", size, path);
        const std::size_t length = number(views[index], "byteLength", 0, path);
        const std::size_t offset = number(accessor, "byteOffset", 0, path);
        if (stride > 65'536 || offset > length || (count - 1) * stride + size > length - offset)
            throw Error("an accessor reaches beyond its bufferView", {path, 0, {}});
    }
}

/// Each node has one parent at most, none is above itself, and none is too deep.
void check_nodes(const json& root, const std::string& path) {
    const json& nodes = list(root, "nodes", path);
    if (nodes.size() > import_limits.nodes)
        throw Error(
            fmt::format("it has {} nodes; the limit is {}", nodes.size(), import_limits.nodes),
            {path, 0, {}});
    constexpr std::size_t no_parent = SIZE_MAX;
    std::vector<std::size_t> parents(nodes.size(), no_parent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (children == nodes[i].end())
            continue;
        for (const json& child : *children) {
            const std::size_t index =
                child.is_number_unsigned() ? child.get<std::size_t>() : nodes.size();
            if (index >= nodes.size())
                throw Error("a node names a child that is not there", {path, 0, {}});
            if (parents[index] != no_parent)
                throw Error("a node is the child of two", {path, 0, {}});
            parents[index] = i;
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        int depth = 0;
        for (std::size_t at = i; at != no_parent; at = parents[at])
            if (++depth > import_limits.depth)
                throw Error(fmt::format("its nodes go round in a ring, or deeper than {}",
                                        import_limits.depth),
                            {path, 0, {}});
    }
}

void check_version(const json& root, const std::string& path) {
    const auto asset = root.find("asset");
    const bool has_version = root.is_object() && asset != root.end() && asset->is_object() &&
                             asset->contains("version") && (*asset)["version"].is_string();
    if (!has_version)
        throw Error("it is no glTF: it has no asset.version", {path, 0, {}});
    const std::string version = (*asset)["version"].get<std::string>();
    if (version.compare(0, 2, "2.") != 0)
        throw Error("it is glTF " + version + "; convert it to glTF 2.0", {path, 0, {}});
    const auto required = root.find("extensionsRequired");
    if (required == root.end() || !required->is_array())
        return;
    for (const json& name : *required)
        if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression")
            throw Error("its meshes are compressed (" + name.get<std::string>() +
                            "); convert it to plain glTF 2.0",
                        {path, 0, {}});
}

void count_left_out(const json& root, const std::string& path, LeftOut& left_out) {
    left_out.add("animations (the rest pose is shown)", list(root, "animations", path).size());
    left_out.add("skins (the rest pose is shown)", list(root, "skins", path).size());
    for (const json& mesh : list(root, "meshes", path))
        for (const json& primitive : list(mesh, "primitives", path))
            left_out.add("morph targets (the rest pose is shown)",
                         list(primitive, "targets", path).size());
    for (const json& material : list(root, "materials", path)) {
        for (const char* map : {"normalTexture", "occlusionTexture"})
            left_out.add("normal and occlusion textures", material.contains(map) ? 1 : 0);
        const auto mode = material.find("alphaMode");
        left_out.add("transparency of materials",
                     mode != material.end() && *mode != "OPAQUE" ? 1 : 0);
        const auto extensions = material.find("extensions");
        if (extensions != material.end() && extensions->is_object())
            for (const auto& [name, unused] : extensions->items())
                if (name != "KHR_materials_emissive_strength")
                    left_out.add("materials' " + name);
    }
}

/// A number of the object, or `usual`.
float fraction(const json& object, const char* pointer, float usual) {
    const json::json_pointer at(pointer);
    return object.contains(at) && object[at].is_number() ? object[at].get<float>() : usual;
}

GltfFacts facts_of(const json& root, const std::string& path) {
    constexpr float most_emission = 65504;
    GltfFacts facts;
    for (const json& material : list(root, "materials", path)) {
        const float strength =
            fraction(material, "/extensions/KHR_materials_emissive_strength/emissiveStrength", 1);
        facts.emissive_strengths.push_back(strength >= 0 ? std::min(strength, most_emission) : 1);
    }
    for (const json& camera : list(root, "cameras", path))
        facts.vertical_fields.push_back(fraction(camera, "/perspective/yfov", 0));
    return facts;
}

} // namespace

GltfFacts check_gltf(const std::string& bytes, const std::string& path, LeftOut& left_out) {
    const json root = parsed(bytes, path);
    check_version(root, path);
    check_ranges(root, path);
    check_nodes(root, path);
    count_left_out(root, path, left_out);
    return facts_of(root, path);
}

} // namespace preview
