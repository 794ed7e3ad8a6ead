// Writes small glTF 2.0 files for tests: a .gltf with its .bin beside it.
#pragma once

#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace preview {

class GltfWriter {
  public:
    using json = nlohmann::json;

    GltfWriter() {
        root = {{"asset", {{"version", "2.0"}}},
                {"scene", 0},
                {"scenes", json::array({{{"nodes", json::array()}}})}};
    }

    /// The index of a row added to one of the file's lists.
    std::size_t add(const char* list, json row) {
        root[list].push_back(std::move(row));
        return root[list].size() - 1;
    }

    /// A node of the scene.
    std::size_t add_node(json node) {
        const std::size_t index = add("nodes", std::move(node));
        root["scenes"][0]["nodes"].push_back(index);
        return index;
    }

    /// An accessor of the numbers as they stand in memory.
    template <class T>
    std::size_t add_accessor(const std::vector<T>& numbers, const char* type,
                             std::size_t components, int component_type) {
        const std::size_t view = add_view(numbers.data(), numbers.size() * sizeof(T));
        return add("accessors", {{"bufferView", view},
                                 {"componentType", component_type},
                                 {"type", type},
                                 {"count", numbers.size() / components}});
    }

    /// A mesh of these corners, three a triangle.
    std::size_t add_mesh(const std::vector<float>& positions, std::size_t material = 0) {
        const std::size_t view = add_view(positions.data(), positions.size() * sizeof(float));
        const std::size_t accessor = add("accessors", {{"bufferView", view},
                                                       {"componentType", 5126},
                                                       {"type", "VEC3"},
                                                       {"count", positions.size() / 3},
                                                       {"min", {-1, -1, -1}},
                                                       {"max", {1, 1, 1}}});
        json primitive = {{"attributes", {{"POSITION", accessor}}}};
        if (root.contains("materials")) {
            primitive["material"] = material;
        }
        return add("meshes", {{"primitives", json::array({primitive})}});
    }

    void write(const std::filesystem::path& path) const {
        json whole = root;
        std::filesystem::path bin = path;
        bin.replace_extension(".bin");
        whole["buffers"] =
            json::array({{{"uri", bin.filename().string()}, {"byteLength", bytes.size()}}});
        std::ofstream(path) << whole.dump(2);
        std::ofstream(bin, std::ios::binary) << bytes;
    }

    /// The buffer as a data URI.
    std::string data_uri() const {
        constexpr const char* digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string padded = bytes + std::string((3 - bytes.size() % 3) % 3, '\0');
        std::string text = "data:application/octet-stream;base64,";
        for (std::size_t at = 0; at < padded.size(); at += 3) {
            std::uint32_t bits = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                bits = bits << 8U | static_cast<unsigned char>(padded[at + i]);
            }
            for (const unsigned shift : {18U, 12U, 6U, 0U}) {
                text += digits[bits >> shift & 63U];
            }
        }
        return text;
    }

    json root;
    std::string bytes;

    std::size_t add_view(const void* data, std::size_t size) {
        const std::size_t at = bytes.size();
        bytes.append(static_cast<const char*>(data), size);
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", size}});
    }
};

/// The square of half side 1 in the plane z = 0, facing +z, without normals.
inline std::vector<float> square_corners() {
    return {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0};
}

} // namespace preview
