// The module that reads OBJ files by Assimp, in a process of its own. A question is the file's
// name, its bytes and the material libraries that are known; the answer names libraries that it
// lacks, or holds the file.
#include "lutlib/error.h"
#include "lutlib/io/box/module_desk.h"
#include "preview/scene/import.h"
#include "preview/scene/obj_file.h"

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>

namespace preview {

namespace {

/// What Assimp may read: what the question holds.
class Given : public Assimp::IOSystem {
  public:
    Given(const std::string& name, const std::string& bytes,
          const std::vector<ObjLibrary>& libraries, std::vector<std::string>& lacking)
        : name_(name), bytes_(bytes), libraries_(libraries), lacking_(lacking) {}

    // Whether it may be read, and can be, shows when it is opened.
    bool Exists(const char*) const override { return true; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char*) override {
        if (file == name_) {
            return stream(bytes_);
        }
        const auto known = std::find_if(libraries_.begin(), libraries_.end(),
                                        [&](const auto& row) { return row.name == file; });
        if (known != libraries_.end()) {
            return known->is_there ? stream(known->bytes) : nullptr;
        }
        if (std::find(lacking_.begin(), lacking_.end(), file) == lacking_.end()) {
            lacking_.emplace_back(file);
        }
        return nullptr;
    }
    void Close(Assimp::IOStream* file) override { delete file; }

  private:
    static Assimp::IOStream* stream(const std::string& bytes) {
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                          bytes.size());
    }

    const std::string& name_;
    const std::string& bytes_;
    const std::vector<ObjLibrary>& libraries_;
    std::vector<std::string>& lacking_;
};

glm::vec3 color(const aiMaterial& material, const char* key, unsigned type, unsigned index,
                glm::vec3 usual) {
    aiColor3D value(usual.x, usual.y, usual.z);
    material.Get(key, type, index, value);
    return {value.r, value.g, value.b};
}

ObjMaterial material_of(const aiMaterial& given) {
    ObjMaterial out;
    out.diffuse = color(given, AI_MATKEY_COLOR_DIFFUSE, out.diffuse);
    out.emission = color(given, AI_MATKEY_COLOR_EMISSIVE, out.emission);
    given.Get(AI_MATKEY_SHININESS, out.exponent);
    given.Get(AI_MATKEY_OPACITY, out.opacity);
    aiString name;
    if (given.GetTexture(aiTextureType_DIFFUSE, 0, &name) == aiReturn_SUCCESS) {
        out.diffuse_map = name.C_Str();
    }
    constexpr std::array<aiTextureType, other_obj_maps.size()> others{
        aiTextureType_NORMALS, aiTextureType_HEIGHT, aiTextureType_SPECULAR, aiTextureType_OPACITY};
    for (std::size_t i = 0; i < others.size(); ++i) {
        out.other_maps[i] = given.GetTextureCount(others[i]);
    }
    return out;
}

ObjMesh mesh_of(const aiMesh& given) {
    ObjMesh out;
    out.name = given.mName.C_Str();
    out.material = given.mMaterialIndex;
    for (unsigned i = 0; i < given.mNumVertices; ++i) {
        const aiVector3D& at = given.mVertices[i];
        out.positions.emplace_back(at.x, at.y, at.z);
        if (given.HasNormals()) {
            const aiVector3D& normal = given.mNormals[i];
            out.normals.emplace_back(normal.x, normal.y, normal.z);
        }
        if (given.HasTextureCoords(0)) {
            out.uv.emplace_back(given.mTextureCoords[0][i].x, given.mTextureCoords[0][i].y);
        }
        if (given.HasVertexColors(0)) {
            const aiColor4D& c = given.mColors[0][i];
            out.colors.emplace_back(c.r, c.g, c.b, c.a);
        }
    }
    for (unsigned i = 0; i < given.mNumFaces; ++i) {
        const aiFace& face = given.mFaces[i];
        if (face.mNumIndices != 3) {
            ++out.points_or_lines;
            continue;
        }
        out.indices.insert(out.indices.end(), face.mIndices, face.mIndices + 3);
    }
    return out;
}

ObjFile file_of(const aiScene& given) {
    ObjFile out;
    for (unsigned i = 0; i < given.mNumMaterials; ++i) {
        out.materials.push_back(material_of(*given.mMaterials[i]));
    }
    std::size_t vertices = 0;
    for (unsigned i = 0; i < given.mNumMeshes; ++i) {
        vertices += given.mMeshes[i]->mNumVertices;
        if (vertices > import_limits.vertices) {
            throw lutlib::Error("it has more vertices than the limit");
        }
        out.meshes.push_back(mesh_of(*given.mMeshes[i]));
    }
    return out;
}

class ObjDesk final : public lutlib::io::box::ModuleDesk {
  public:
    void answer(lutlib::io::box::Incoming& question,
                lutlib::io::box::Outgoing& answer) const override {
        const std::string name = question.take_text(), bytes = question.take_text();
        const std::vector<ObjLibrary> libraries = take_obj_libraries(question);
        std::vector<std::string> lacking;
        Assimp::Importer importer;
        importer.SetIOHandler(new Given(name, bytes, libraries, lacking)); // which owns it
        const aiScene* const file =
            importer.ReadFile(name, aiProcess_Triangulate | aiProcess_PreTransformVertices);
        answer.put_texts(lacking);
        if (!lacking.empty()) {
            return;
        }
        if (file == nullptr || file->mRootNode == nullptr || file->mNumMaterials == 0) {
            const std::string why = importer.GetErrorString();
            throw lutlib::Error(
                "not a usable OBJ file: " +
                (why.empty() ? "no line of it is one of an OBJ; save it as UTF-8" : why));
        }
        put(answer, file_of(*file));
    }
};

} // namespace

} // namespace preview

extern "C" __attribute__((visibility("default"))) const lutlib::io::box::ModuleDesk*
lutpreview_obj();

extern "C" const lutlib::io::box::ModuleDesk* lutpreview_obj() {
    static const preview::ObjDesk desk;
    return &desk;
}
