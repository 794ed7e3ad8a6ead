#include "lutlib/error.h"
#include "lutlib/io/box/module_desk.h"
#include "preview/scene/import_parts.h"
#include "preview/scene/obj_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

namespace preview {

namespace {

using lutlib::Error;

constexpr lutlib::io::box::Foreign assimp{"lutpreview_obj", "lutpreview_obj", "Assimp"};

/// Reads what the module lacks, until it lacks nothing.
ObjFile read_obj(const std::string& bytes, const std::string& path, const ReadFile& read,
                 LeftOut& left_out) {
    namespace box = lutlib::io::box;
    constexpr std::size_t most_libraries = 256;
    const std::string name = std::filesystem::path(path).filename().string();
    std::vector<ObjLibrary> libraries;
    std::size_t size = bytes.size();
    bool is_told = false;
    while (true) {
        const box::About about{path, size};
        box::Outgoing asked = box::question(about);
        asked.put(std::string_view(name));
        asked.put(std::string_view(bytes));
        put(asked, libraries);
        box::Incoming answer = ask_module(assimp, asked, about);
        const std::vector<std::string> lacking = answer.take_texts();
        if (lacking.empty()) {
            return take_obj_file(answer);
        }
        if (libraries.size() + lacking.size() > most_libraries) {
            throw Error("it names more material libraries than the limit", {path, 0, {}});
        }
        for (const std::string& library : lacking) {
            try {
                libraries.push_back({library, read(library, import_limits.file_bytes), true});
                size += libraries.back().bytes.size();
            } catch (const Error& error) {
                // Of a library that it cannot open Assimp tries a second name, which nobody gave.
                if (!std::exchange(is_told, true)) {
                    left_out.add("material libraries that cannot be read: " +
                                 printable(error.what(), 240));
                }
                libraries.push_back({library, {}, false});
            }
        }
    }
}

glm::vec3 unit_color(const glm::vec3& given, glm::vec3 usual) {
    glm::vec3 out;
    for (int c = 0; c < 3; ++c) {
        out[c] = std::isfinite(given[c]) ? std::clamp(given[c], 0.0F, 1.0F) : usual[c];
    }
    return out;
}

class ObjImport {
  public:
    ObjImport(ObjFile file, const std::string& path, const ReadFile& read, LeftOut& left_out)
        : file_(std::move(file)), path_(path), read_(read), left_out_(left_out) {}

    FileScene run() {
        for (const ObjMaterial& material : file_.materials) {
            out_.scene.materials.push_back(material_of(material));
        }
        std::size_t vertices = 0;
        for (ObjMesh& given : file_.meshes) {
            const std::uint32_t material = given.material;
            left_out_.add("points or lines", given.points_or_lines);
            Mesh mesh = mesh_of(given_mesh(std::move(given)), left_out_);
            vertices += mesh.vertices.size();
            if (vertices > import_limits.vertices) {
                throw Error("it has more vertices than the limit", {path_, 0, {}});
            }
            if (!mesh.indices.empty()) {
                // Light falls through what is blended.
                const bool is_blended = out_.scene.materials[material].detail.is_blended;
                out_.scene.objects.push_back({static_cast<std::uint32_t>(out_.scene.meshes.size()),
                                              material, glm::mat4(1), !is_blended});
                out_.scene.meshes.push_back(std::move(mesh));
            }
        }
        return std::move(out_);
    }

  private:
    GivenMesh given_mesh(ObjMesh given) const {
        GivenMesh out;
        out.name = printable(given.name);
        out.is_double_sided = true; // OBJ does not say; its files count on both sides
        out.positions = std::move(given.positions);
        out.normals = std::move(given.normals);
        out.colors = std::move(given.colors);
        out.indices = std::move(given.indices);
        if (!(out_.scene.materials[given.material].detail == MaterialDetail{})) {
            out.uv[0] = std::move(given.uv);
            for (glm::vec2& uv : out.uv[0]) {
                uv.y = 1 - uv.y; // it grows upwards in OBJ
            }
        }
        return out;
    }

    /// Phong's numbers as a rough dielectric: an exponent n is about alpha = sqrt(2 / (n + 2)),
    /// Walter et al. 2007, "Microfacet models for refraction through rough surfaces".
    Material material_of(const ObjMaterial& given) {
        Material out;
        out.albedo = unit_color(given.diffuse, glm::vec3(0.6F));
        out.emission = unit_color(given.emission, glm::vec3(0));
        const float exponent = given.exponent >= 0 ? std::min(given.exponent, 1e5F) : 0;
        out.roughness = std::sqrt(std::sqrt(2 / (exponent + 2)));
        if (given.opacity < 1) {
            out.detail.is_blended = true;
            out.detail.coverage = std::max(given.opacity, 0.0F);
        }
        if (!given.diffuse_map.empty()) {
            out.detail.base.texture = texture_named(given.diffuse_map);
            if (out.detail.base.texture != TextureUse::none && out.albedo == glm::vec3(0)) {
                out.albedo = glm::vec3(1);
            }
        }
        for (std::size_t i = 0; i < other_obj_maps.size(); ++i) {
            left_out_.add(std::string("textures of ") + other_obj_maps[i], given.other_maps[i]);
        }
        return out;
    }

    std::uint32_t texture_named(std::string name) {
        std::replace(name.begin(), name.end(), '\\', '/');
        const auto [known, is_new] = textures_.try_emplace(name, TextureUse::none);
        if (!is_new) {
            return known->second;
        }
        try {
            Picture picture = picture_of(read_(name, import_limits.file_bytes), printable(name));
            texels_ += picture.rgba.size() / 4;
            if (texels_ > import_limits.texels) {
                throw Error("its textures have more texels than the limit", {path_, 0, {}});
            }
            Texture texture;
            texture.picture = static_cast<std::uint32_t>(out_.scene.pictures.size());
            texture.is_color = true;
            known->second = static_cast<std::uint32_t>(out_.scene.textures.size());
            out_.scene.pictures.push_back(std::move(picture));
            out_.scene.textures.push_back(texture);
        } catch (const Error& error) {
            left_out_.add("pictures that cannot be read: " + printable(error.what(), 240));
        }
        return known->second;
    }

    ObjFile file_;
    const std::string& path_;
    const ReadFile& read_;
    LeftOut& left_out_;
    FileScene out_;
    std::map<std::string, std::uint32_t> textures_;
    std::size_t texels_ = 0;
};

} // namespace

FileScene obj_scene(const std::string& bytes, const std::string& path, const ReadFile& read,
                    LeftOut& left_out) {
    return ObjImport(read_obj(bytes, path, read, left_out), path, read, left_out).run();
}

} // namespace preview
