#include "preview/scene/import.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/scene/gltf_file.h"
#include "preview/scene/import_parts.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

namespace preview {

namespace {

using lutlib::Error;

constexpr glm::vec3 fit_centre{0.26F, 0.62F, -0.1F}; // where the sample's camera looks
constexpr float fit_radius = 1.5F;
/// Coordinates beyond it are as good as infinite: areas' squares must be floats.
constexpr float most_coordinate = 1e9F;

/// The file system, in which the file at `path` holds other bytes.
class ReducedFile : public Assimp::DefaultIOSystem {
  public:
    ReducedFile(std::string path, std::string bytes)
        : path_(std::move(path)), bytes_(std::move(bytes)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (file != path_) {
            return DefaultIOSystem::Open(file, mode);
        }
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()),
                                          bytes_.size());
    }

  private:
    std::string path_, bytes_;
};

bool is_usable(const aiVector3D& v) {
    return std::abs(v.x) < most_coordinate && std::abs(v.y) < most_coordinate &&
           std::abs(v.z) < most_coordinate; // false for NaN
}

glm::vec3 vector(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

glm::mat4 matrix(const aiMatrix4x4& m) {
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2,
            m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

bool is_usable(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(m[column][row]) < most_coordinate)) {
                return false;
            }
        }
    }
    return true;
}

/// Makes one mesh of the scene: triangles without a length, or with a vertex that is no place, are
/// left out; normals that are missing or no direction become the triangle's own.
class MeshImport {
  public:
    MeshImport(const aiMesh& given, bool is_double_sided, LeftOut& left_out)
        : given_(given), is_double_sided_(is_double_sided), left_out_(left_out) {}

    Mesh run() {
        out_.name = given_.mName.C_Str();
        for (unsigned face = 0; face < given_.mNumFaces; ++face) {
            add(given_.mFaces[face]);
        }
        return std::move(out_);
    }

  private:
    void add(const aiFace& face) {
        if (face.mNumIndices != 3) {
            left_out_.add("faces that are not triangles");
            return;
        }
        glm::vec3 corners[3];
        for (unsigned i = 0; i < 3; ++i) {
            const unsigned index = face.mIndices[i];
            if (index >= given_.mNumVertices || !is_usable(given_.mVertices[index])) {
                left_out_.add("triangles with a missing or non-finite vertex");
                return;
            }
            corners[i] = vector(given_.mVertices[index]);
        }
        const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const float area = glm::length(across);
        if (!(area > 0)) {
            return; // nobody could see it
        }
        const glm::vec3 flat = across / area;
        for (unsigned i = 0; i < 3; ++i) {
            out_.indices.push_back(vertex(face.mIndices[i], corners[i], flat, 1));
        }
        if (is_double_sided_) {
            for (const unsigned i : {0U, 2U, 1U}) {
                out_.indices.push_back(vertex(face.mIndices[i], corners[i], flat, -1));
            }
        }
    }

    /// The index of a corner; those with a normal of their own are shared between triangles.
    std::uint32_t vertex(unsigned index, glm::vec3 position, glm::vec3 flat, int side) {
        const auto at = static_cast<std::uint32_t>(out_.vertices.size());
        const auto facing = static_cast<float>(side);
        const glm::vec3 normal =
            given_.HasNormals() ? vector(given_.mNormals[index]) : glm::vec3(0);
        const float length = glm::length(normal);
        if (!(length > 0.01F && length < 100)) {
            out_.vertices.push_back({position, facing * flat});
            return at;
        }
        std::vector<std::uint32_t>& shared = side > 0 ? front_ : back_;
        if (shared.empty()) {
            shared.assign(given_.mNumVertices, unknown);
        }
        if (shared[index] == unknown) {
            shared[index] = at;
            out_.vertices.push_back({position, facing * normal / length});
        }
        return shared[index];
    }

    static constexpr std::uint32_t unknown = UINT32_MAX;
    const aiMesh& given_;
    bool is_double_sided_;
    LeftOut& left_out_;
    Mesh out_;
    std::vector<std::uint32_t> front_, back_; ///< by the given index
};

void import_meshes(const aiScene& file, const std::string& path, Scene& scene, LeftOut& left_out) {
    std::size_t vertices = 0;
    for (unsigned i = 0; i < file.mNumMeshes; ++i) {
        const aiMesh& given = *file.mMeshes[i];
        int two_sided = 0;
        file.mMaterials[given.mMaterialIndex]->Get(AI_MATKEY_TWOSIDED, two_sided);
        scene.meshes.push_back(MeshImport(given, two_sided != 0, left_out).run());
        vertices += scene.meshes.back().vertices.size();
        if (vertices > import_limits.vertices) {
            throw Error(fmt::format("it has more than {} vertices, which is the limit",
                                    import_limits.vertices),
                        {path, 0, {}});
        }
    }
}

/// Every node's place in the file's world, and an object for each mesh of each.
Places import_nodes(const aiScene& file, const std::string& path, Scene& scene, LeftOut& left_out) {
    Places places;
    std::vector<std::pair<const aiNode*, glm::mat4>> open{{file.mRootNode, glm::mat4(1)}};
    while (!open.empty()) {
        const auto [node, above] = open.back();
        open.pop_back();
        const glm::mat4 place = above * matrix(node->mTransformation);
        if (!is_usable(place)) {
            left_out.add("nodes whose transform is not finite");
            continue;
        }
        places.emplace(node->mName.C_Str(), place);
        for (unsigned i = 0; i < node->mNumMeshes; ++i) {
            const unsigned mesh = node->mMeshes[i];
            if (mesh < scene.meshes.size() && !scene.meshes[mesh].indices.empty()) {
                scene.objects.push_back({mesh, file.mMeshes[mesh]->mMaterialIndex, place, true});
            }
        }
        if (scene.objects.size() > import_limits.nodes) {
            throw Error(
                fmt::format("it has more than {} objects, which is the limit", import_limits.nodes),
                {path, 0, {}});
        }
        // The last is taken first.
        for (unsigned i = node->mNumChildren; i > 0; --i) {
            open.emplace_back(node->mChildren[i - 1], place);
        }
    }
    return places;
}

/// Carries the file's world to where the built-in scene stands.
glm::mat4 fit_of(const Scene& scene, const std::string& path) {
    const Bounds box = scene.bounds();
    const glm::vec3 size = box.max - box.min;
    const float radius = glm::length(size) / 2;
    if (box.empty() || !(radius > 0) || !(radius < most_coordinate)) {
        throw Error("it holds no triangles to show", {path, 0, {}});
    }
    const float scale = fit_radius / radius;
    glm::mat4 fit(scale);
    fit[3] = glm::vec4(fit_centre - scale * (box.min + size / 2.0F), 1);
    return fit;
}

} // namespace

std::vector<std::string> LeftOut::lines() const {
    std::vector<std::string> lines;
    for (const auto& [what, count] : counts_) {
        lines.push_back(fmt::format("{} {}", count, what));
    }
    return lines;
}

bool is_model_file(const std::string& path) {
    const std::string extension = lutlib::io::extension_of(path);
    return extension == "gltf" || extension == "glb";
}

ImportedScene import_scene(const std::string& path) {
    LeftOut left_out;
    GltfFile gltf(lutlib::io::read_file(path, import_limits.file_bytes), path);
    check_gltf(gltf, path);
    const GltfFacts facts = facts_of(gltf.root);
    reduce_gltf(gltf.root, left_out);
    Assimp::Importer importer;
    importer.SetIOHandler(new ReducedFile(path, gltf.to_bytes())); // which owns it
    const aiScene* const file = importer.ReadFile(path, 0);
    if (file == nullptr || file->mRootNode == nullptr) {
        throw Error(fmt::format("not a usable glTF file: {}", importer.GetErrorString()),
                    {path, 0, {}});
    }

    ImportedScene out;
    Scene& scene = out.scene;
    import_meshes(*file, path, scene, left_out);
    const std::string folder = std::filesystem::path(path).parent_path().string();
    for (unsigned i = 0; i < file->mNumMaterials; ++i) {
        scene.materials.push_back(import_material(*file, *file->mMaterials[i], folder, left_out));
        if (i < facts.emissive_strengths.size()) {
            scene.materials.back().emission *= facts.emissive_strengths[i];
        }
    }
    const Places places = import_nodes(*file, path, scene, left_out);
    const glm::mat4 fit = fit_of(scene, path);
    for (Object& object : scene.objects) {
        object.transform = fit * object.transform;
    }
    import_view(*file, facts, places, fit, scene, left_out);
    out.left_out = left_out.lines();
    return out;
}

} // namespace preview
