#include "lutlib/error.h"
#include "preview/scene/import_parts.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace preview {

namespace {

using lutlib::Error;

/// What Assimp may read: the file that is in memory, and regular files beside it.
class Beside : public Assimp::IOSystem {
  public:
    Beside(std::string path, const std::string& bytes, ReadFile read, LeftOut& left_out)
        : path_(std::move(path)), bytes_(bytes), read_(std::move(read)), left_out_(left_out) {}

    // Whether it may be read, and can be, shows when it is opened.
    bool Exists(const char*) const override { return true; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char*) override {
        if (file == path_) {
            return stream(bytes_);
        }
        try {
            return stream(kept_.emplace(file, read_(name_in_folder(file), import_limits.file_bytes))
                              .first->second);
        } catch (const Error& error) {
            // Of a library that it cannot open Assimp tries a second name, which nobody gave.
            if (!std::exchange(is_told_, true)) {
                left_out_.add("material libraries that cannot be read: " +
                              printable(error.what(), 240));
            }
            return nullptr;
        }
    }
    void Close(Assimp::IOStream* file) override { delete file; }

  private:
    /// Assimp puts the OBJ file's folder before what the file names.
    std::string name_in_folder(std::string_view file) const {
        const std::string folder = path_.substr(0, path_.rfind('/') + 1);
        return std::string(file.substr(file.starts_with(folder) ? folder.size() : 0));
    }
    static Assimp::IOStream* stream(const std::string& bytes) {
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                          bytes.size());
    }

    std::string path_;
    const std::string& bytes_;
    ReadFile read_;
    LeftOut& left_out_;
    bool is_told_ = false;
    std::map<std::string, std::string> kept_;
};

glm::vec3 unit_color(const aiMaterial& material, const char* key, unsigned type, unsigned index,
                     glm::vec3 usual) {
    aiColor3D value(usual.x, usual.y, usual.z);
    material.Get(key, type, index, value);
    glm::vec3 out(value.r, value.g, value.b);
    for (int c = 0; c < 3; ++c) {
        out[c] = std::isfinite(out[c]) ? std::clamp(out[c], 0.0F, 1.0F) : usual[c];
    }
    return out;
}

class ObjImport {
  public:
    ObjImport(const aiScene& file, const std::string& path, const ReadFile& read, LeftOut& left_out)
        : file_(file), path_(path), read_(read), left_out_(left_out) {}

    FileScene run() {
        for (unsigned i = 0; i < file_.mNumMaterials; ++i) {
            out_.scene.materials.push_back(material_of(*file_.mMaterials[i]));
        }
        std::size_t vertices = 0;
        for (unsigned i = 0; i < file_.mNumMeshes; ++i) {
            const aiMesh& given = *file_.mMeshes[i];
            Mesh mesh = mesh_of(given_mesh(given), left_out_);
            vertices += mesh.vertices.size();
            if (vertices > import_limits.vertices) {
                throw Error("it has more vertices than the limit", {path_, 0, {}});
            }
            if (!mesh.indices.empty()) {
                // Light falls through what is blended.
                const bool is_blended =
                    out_.scene.materials[given.mMaterialIndex].detail.is_blended;
                out_.scene.objects.push_back({static_cast<std::uint32_t>(out_.scene.meshes.size()),
                                              given.mMaterialIndex, glm::mat4(1), !is_blended});
                out_.scene.meshes.push_back(std::move(mesh));
            }
        }
        return std::move(out_);
    }

  private:
    GivenMesh given_mesh(const aiMesh& given) const {
        GivenMesh out;
        out.name = printable(given.mName.C_Str());
        out.is_double_sided = true; // OBJ does not say; its files count on both sides
        const MaterialDetail& detail = out_.scene.materials[given.mMaterialIndex].detail;
        for (unsigned i = 0; i < given.mNumVertices; ++i) {
            out.positions.emplace_back(given.mVertices[i].x, given.mVertices[i].y,
                                       given.mVertices[i].z);
            if (given.HasNormals()) {
                out.normals.emplace_back(given.mNormals[i].x, given.mNormals[i].y,
                                         given.mNormals[i].z);
            }
            if (given.HasTextureCoords(0) && !(detail == MaterialDetail{})) {
                // v grows upwards in OBJ.
                out.uv[0].emplace_back(given.mTextureCoords[0][i].x,
                                       1 - given.mTextureCoords[0][i].y);
            }
            if (given.HasVertexColors(0)) {
                const aiColor4D& c = given.mColors[0][i];
                out.colors.emplace_back(c.r, c.g, c.b, c.a);
            }
        }
        for (unsigned i = 0; i < given.mNumFaces; ++i) {
            const aiFace& face = given.mFaces[i];
            if (face.mNumIndices != 3) {
                left_out_.add("points or lines");
                continue;
            }
            out.indices.insert(out.indices.end(), face.mIndices, face.mIndices + 3);
        }
        return out;
    }

    /// Phong's numbers as a rough dielectric: an exponent n is about alpha = sqrt(2 / (n + 2)),
    /// Walter et al. 2007, "Microfacet models for refraction through rough surfaces".
    Material material_of(const aiMaterial& given) {
        Material out;
        out.albedo = unit_color(given, AI_MATKEY_COLOR_DIFFUSE, glm::vec3(0.6F));
        out.emission = unit_color(given, AI_MATKEY_COLOR_EMISSIVE, glm::vec3(0));
        float exponent = 0;
        given.Get(AI_MATKEY_SHININESS, exponent);
        if (!(exponent >= 0)) {
            exponent = 0;
        }
        out.roughness = std::sqrt(std::sqrt(2 / (std::min(exponent, 1e5F) + 2)));
        float opacity = 1;
        given.Get(AI_MATKEY_OPACITY, opacity);
        if (opacity < 1) {
            out.detail.is_blended = true;
            out.detail.coverage = std::max(opacity, 0.0F);
        }
        aiString name;
        if (given.GetTexture(aiTextureType_DIFFUSE, 0, &name) == aiReturn_SUCCESS) {
            out.detail.base.texture = texture_named(name.C_Str());
            if (out.detail.base.texture != TextureUse::none && out.albedo == glm::vec3(0)) {
                out.albedo = glm::vec3(1);
            }
        }
        for (const auto& [type, what] :
             {std::pair{aiTextureType_NORMALS, "norm"}, std::pair{aiTextureType_HEIGHT, "map_bump"},
              std::pair{aiTextureType_SPECULAR, "map_Ks"},
              std::pair{aiTextureType_OPACITY, "map_d"}}) {
            left_out_.add(std::string("textures of ") + what, given.GetTextureCount(type));
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

    const aiScene& file_;
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
    Assimp::Importer importer;
    importer.SetIOHandler(new Beside(path, bytes, read, left_out)); // which owns it
    const aiScene* const file =
        importer.ReadFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices);
    if (file == nullptr || file->mRootNode == nullptr || file->mNumMaterials == 0) {
        const std::string why = printable(importer.GetErrorString());
        throw Error("not a usable OBJ file: " +
                        (why.empty() ? "no line of it is one of an OBJ; save it as UTF-8" : why),
                    {path, 0, {}});
    }
    return ObjImport(*file, path, read, left_out).run();
}

} // namespace preview
