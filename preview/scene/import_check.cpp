#include "preview/scene/gltf_file.h"

#include "lutlib/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace preview {

namespace {

using lutlib::Error;
using nlohmann::json;

/// A number that counts or points to something; `usual` where there is none.
std::size_t number(const json& object, const char* key, std::size_t usual,
                   const std::string& path) {
    const auto found = object.find(key);
    if (found == object.end()) {
        return usual;
    }
    if (!found->is_number_unsigned()) {
        throw Error(fmt::format("'{}' is not a valid count or index", key),
                    {path, 0, found->dump().substr(0, 80)});
    }
    return found->get<std::size_t>();
}

/// The row that the object's member names, or null where it names none.
const json* named_row(const json& object, const char* key, const json& rows,
                      const std::string& path) {
    if (!object.contains(key)) {
        return nullptr;
    }
    const std::size_t index = number(object, key, 0, path);
    if (index >= rows.size()) {
        throw Error(fmt::format("'{}' names something that does not exist", key),
                    {path, 0, std::to_string(index)});
    }
    return &rows[index];
}

struct ElementType {
    std::string_view name;
    std::size_t components;
};
constexpr ElementType element_types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                         {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};

std::size_t component_bytes(std::size_t type, const std::string& path) {
    constexpr std::size_t bytes[] = {1, 1, 2, 2, 0, 4, 4}; // from 5120, signed bytes, on
    if (type < 5120 || type > 5126 || bytes[type - 5120] == 0) {
        throw Error("an accessor has no known componentType", {path, 0, std::to_string(type)});
    }
    return bytes[type - 5120];
}

std::size_t element_bytes(const json& accessor, const std::string& path) {
    const json type = accessor.value("type", json());
    for (const ElementType& row : element_types) {
        if (type == row.name) {
            return row.components *
                   component_bytes(number(accessor, "componentType", 0, path), path);
        }
    }
    throw Error("an accessor has no known type", {path, 0, type.dump().substr(0, 80)});
}

void check_views(const GltfFile& file, const std::string& path) {
    const json& buffers = gltf_list(file.root, "buffers", path);
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::size_t bytes = number(buffers[i], "byteLength", 0, path);
        const bool in_body = file.is_binary && i == 0 && !buffers[i].contains("uri");
        if (bytes > import_limits.file_bytes || (in_body && bytes > file.body_bytes())) {
            throw Error("a buffer is larger than its file, or than the limit", {path, 0, {}});
        }
    }
    for (const json& view : gltf_list(file.root, "bufferViews", path)) {
        const json* const buffer = named_row(view, "buffer", buffers, path);
        const std::size_t whole = buffer ? number(*buffer, "byteLength", 0, path) : 0;
        const std::size_t length = number(view, "byteLength", 0, path);
        if (length > whole || number(view, "byteOffset", 0, path) > whole - length) {
            throw Error("a bufferView reaches beyond its buffer", {path, 0, {}});
        }
    }
}

void check_accessors(const json& root, const std::string& path) {
    const json& views = gltf_list(root, "bufferViews", path);
    std::size_t elements = 0;
    for (const json& accessor : gltf_list(root, "accessors", path)) {
        const std::size_t count = number(accessor, "count", 0, path);
        elements += std::min(count, import_limits.elements + 1);
        if (elements > import_limits.elements) {
            throw Error(fmt::format("its accessors hold more than {} elements, which is the limit",
                                    import_limits.elements),
                        {path, 0, {}});
        }
        if (accessor.contains("sparse")) {
            throw Error("it has sparse accessors; convert it to plain ones", {path, 0, {}});
        }
        const std::size_t size = element_bytes(accessor, path);
        const json* const view = named_row(accessor, "bufferView", views, path);
        if (view == nullptr || count == 0) {
            continue;
        }
        const std::size_t stride = number(*view, "byteStride", size, path);
        const std::size_t length = number(*view, "byteLength", 0, path);
        const std::size_t offset = number(accessor, "byteOffset", 0, path);
        if (stride < size || stride > 65'536 || offset > length ||
            (count - 1) * stride + size > length - offset) {
            throw Error("an accessor reaches beyond its bufferView", {path, 0, {}});
        }
    }
}

bool has_type(const json* accessor, std::string_view type,
              std::initializer_list<std::size_t> components) {
    return accessor == nullptr ||
           (accessor->value("type", json()) == type &&
            std::any_of(components.begin(), components.end(), [&](std::size_t component) {
                return accessor->value("componentType", json()) == component;
            }));
}

void check_meshes(const json& root, const std::string& path) {
    constexpr std::size_t u8 = 5121, u16 = 5123, u32 = 5125, f32 = 5126;
    const json& accessors = gltf_list(root, "accessors", path);
    const json& materials = gltf_list(root, "materials", path);
    for (const json& mesh : gltf_list(root, "meshes", path)) {
        for (const json& primitive : gltf_list(mesh, "primitives", path)) {
            const auto attributes = primitive.find("attributes");
            if (attributes == primitive.end() || !attributes->is_object()) {
                throw Error("a mesh has no attributes", {path, 0, {}});
            }
            const json* const positions = named_row(*attributes, "POSITION", accessors, path);
            const json* const normals = named_row(*attributes, "NORMAL", accessors, path);
            if (!has_type(positions, "VEC3", {f32}) || !has_type(normals, "VEC3", {f32}) ||
                !has_type(named_row(primitive, "indices", accessors, path), "SCALAR",
                          {u8, u16, u32})) {
                throw Error("a mesh has positions, normals or indices of a wrong type",
                            {path, 0, {}});
            }
            if (normals != nullptr &&
                (positions == nullptr || (*normals)["count"] != (*positions)["count"])) {
                throw Error("a mesh has not as many normals as positions", {path, 0, {}});
            }
            named_row(primitive, "material", materials, path);
        }
    }
}

/// Each node has one parent at most, none is above itself, and none is too deep.
void check_nodes(const json& root, const std::string& path) {
    const json& nodes = gltf_list(root, "nodes", path);
    if (nodes.size() > import_limits.nodes) {
        throw Error(
            fmt::format("it has {} nodes; the limit is {}", nodes.size(), import_limits.nodes),
            {path, 0, {}});
    }
    constexpr std::size_t no_parent = SIZE_MAX;
    std::vector<std::size_t> parents(nodes.size(), no_parent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (children == nodes[i].end()) {
            continue;
        }
        for (const json& child : *children) {
            const std::size_t index =
                child.is_number_unsigned() ? child.get<std::size_t>() : nodes.size();
            if (index >= nodes.size()) {
                throw Error("a node names a child that does not exist", {path, 0, {}});
            }
            if (parents[index] != no_parent) {
                throw Error("a node has two parents", {path, 0, {}});
            }
            parents[index] = i;
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        int depth = 0;
        for (std::size_t at = i; at != no_parent; at = parents[at]) {
            if (++depth > import_limits.depth) {
                throw Error(fmt::format("its node tree has a cycle, or is deeper than {}",
                                        import_limits.depth),
                            {path, 0, {}});
            }
        }
    }
}

void check_names(const json& root, const std::string& path) {
    for (const json& node : gltf_list(root, "nodes", path)) {
        named_row(node, "mesh", gltf_list(root, "meshes", path), path);
        named_row(node, "camera", gltf_list(root, "cameras", path), path);
    }
    for (const json& image : gltf_list(root, "images", path)) {
        named_row(image, "bufferView", gltf_list(root, "bufferViews", path), path);
    }
    for (const json& texture : gltf_list(root, "textures", path)) {
        named_row(texture, "source", gltf_list(root, "images", path), path);
    }
}

void check_extensions(const json& root, const std::string& path) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end() || !required->is_array()) {
        return;
    }
    for (const json& name : *required) {
        if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression") {
            throw Error("its meshes are compressed (" + name.get<std::string>() +
                            "); convert it to plain glTF 2.0",
                        {path, 0, {}});
        }
    }
}

} // namespace

void check_gltf(const GltfFile& file, const std::string& path) {
    check_extensions(file.root, path);
    check_views(file, path);
    check_accessors(file.root, path);
    check_meshes(file.root, path);
    check_nodes(file.root, path);
    check_names(file.root, path);
}

} // namespace preview
