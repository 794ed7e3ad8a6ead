#include "preview/scene/obj_file.h"

#include "lutlib/error.h"

namespace preview {

namespace {

using lutlib::io::box::Incoming;
using lutlib::io::box::Outgoing;
using lutlib::io::box::Plain;

template <Plain T>
void put_all(Outgoing& to, const std::vector<T>& values) {
    to.put_all(std::span<const T>(values));
}

template <class T>
void hold_length(const std::vector<T>& attribute, const ObjMesh& mesh) {
    if (!attribute.empty() && attribute.size() != mesh.positions.size()) {
        throw lutlib::Error("the process that reads models sent a damaged mesh");
    }
}

ObjMaterial take_material(Incoming& from) {
    ObjMaterial out;
    out.diffuse = from.take<glm::vec3>();
    out.emission = from.take<glm::vec3>();
    out.exponent = from.take<float>();
    out.opacity = from.take<float>();
    out.diffuse_map = from.take_text();
    out.other_maps = from.take<decltype(out.other_maps)>();
    return out;
}

ObjMesh take_mesh(Incoming& from, std::size_t materials) {
    ObjMesh out;
    out.name = from.take_text();
    out.material = from.take<std::uint32_t>();
    out.positions = from.take_all<glm::vec3>();
    out.normals = from.take_all<glm::vec3>();
    out.uv = from.take_all<glm::vec2>();
    out.colors = from.take_all<glm::vec4>();
    out.indices = from.take_all<std::uint32_t>();
    out.points_or_lines = from.take<std::uint64_t>();
    hold_length(out.normals, out);
    hold_length(out.uv, out);
    hold_length(out.colors, out);
    if (out.material >= materials) {
        throw lutlib::Error("the process that reads models sent a damaged mesh");
    }
    return out;
}

} // namespace

void put(Outgoing& to, const ObjFile& file) {
    to.put(std::uint64_t{file.materials.size()});
    for (const ObjMaterial& material : file.materials) {
        to.put(material.diffuse);
        to.put(material.emission);
        to.put(material.exponent);
        to.put(material.opacity);
        to.put(std::string_view(material.diffuse_map));
        to.put(material.other_maps);
    }
    to.put(std::uint64_t{file.meshes.size()});
    for (const ObjMesh& mesh : file.meshes) {
        to.put(std::string_view(mesh.name));
        to.put(mesh.material);
        put_all(to, mesh.positions);
        put_all(to, mesh.normals);
        put_all(to, mesh.uv);
        put_all(to, mesh.colors);
        put_all(to, mesh.indices);
        to.put(mesh.points_or_lines);
    }
}

// Whatever the counts say, the message ends before there is no memory.
ObjFile take_obj_file(Incoming& from) {
    ObjFile out;
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        out.materials.push_back(take_material(from));
    }
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        out.meshes.push_back(take_mesh(from, out.materials.size()));
    }
    return out;
}

void put(Outgoing& to, const std::vector<ObjLibrary>& libraries) {
    to.put(std::uint64_t{libraries.size()});
    for (const ObjLibrary& library : libraries) {
        to.put(std::string_view(library.name));
        to.put(std::string_view(library.bytes));
        to.put(std::uint8_t{library.is_there});
    }
}

std::vector<ObjLibrary> take_obj_libraries(Incoming& from) {
    std::vector<ObjLibrary> out;
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        ObjLibrary& library = out.emplace_back();
        library.name = from.take_text();
        library.bytes = from.take_text();
        library.is_there = from.take_bool();
    }
    return out;
}

} // namespace preview
