// What an OBJ file holds, as it comes from the process that reads it (obj_module.cpp).
#pragma once

#include "lutlib/io/box/message.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace preview {

/// Of a material, what the renderer has nothing for.
inline constexpr std::array<const char*, 4> other_obj_maps{"norm", "map_bump", "map_Ks", "map_d"};

struct ObjMaterial {
    glm::vec3 diffuse{0.6F}, emission{0}; ///< as they stand there; may be anything
    float exponent = 0, opacity = 1;
    std::string diffuse_map; ///< a file's name; empty: none
    std::array<std::uint32_t, other_obj_maps.size()> other_maps{};
};

struct ObjMesh {
    std::string name;
    std::uint32_t material = 0;
    /// An attribute is empty or as long as `positions`.
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uv; ///< v grows upwards
    std::vector<glm::vec4> colors;
    std::vector<std::uint32_t> indices; ///< three a triangle; may point anywhere
    std::uint64_t points_or_lines = 0;
};

struct ObjFile {
    std::vector<ObjMaterial> materials;
    std::vector<ObjMesh> meshes;
};

void put(lutlib::io::box::Outgoing& to, const ObjFile& file);
/// Throws lutlib::Error for what is no such file.
ObjFile take_obj_file(lutlib::io::box::Incoming& from);

/// A material library that the file asks for, and its bytes where it can be read.
struct ObjLibrary {
    std::string name, bytes;
    bool is_there = false;
};

void put(lutlib::io::box::Outgoing& to, const std::vector<ObjLibrary>& libraries);
std::vector<ObjLibrary> take_obj_libraries(lutlib::io::box::Incoming& from);

} // namespace preview
