// Triangles of a glTF file, with skins in the bind pose.
#include "preview/scene/gltf_parts.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <map>

namespace preview {

namespace {

using nlohmann::json;

template <class V>
std::vector<V> vectors_of(const std::vector<float>& numbers) {
    std::vector<V> out(numbers.size() / static_cast<std::size_t>(V::length()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto length = static_cast<std::size_t>(V::length());
        out[i / length][static_cast<int>(i % length)] = numbers[i];
    }
    return out;
}

template <class V>
std::vector<V> attribute(const GltfFile& file, const json& attributes, const std::string& key) {
    const auto accessor = file.index(attributes, key.c_str(), "accessors");
    return accessor
               ? vectors_of<V>(gltf_floats(file, *accessor, static_cast<std::size_t>(V::length())))
               : std::vector<V>();
}

/// Colours have three or four components.
std::vector<glm::vec4> colors_of(const GltfFile& file, const json& attributes) {
    const auto accessor = file.index(attributes, "COLOR_0", "accessors");
    if (!accessor || gltf_components(file, *accessor) != 3) {
        return attribute<glm::vec4>(file, attributes, "COLOR_0");
    }
    std::vector<glm::vec4> out;
    for (const glm::vec3& color : attribute<glm::vec3>(file, attributes, "COLOR_0")) {
        out.emplace_back(color, 1);
    }
    return out;
}

/// Corners of the triangles that a list, a strip or a fan stands for. glTF 2.0, 3.7.2.1.
std::vector<std::uint32_t> triangles_of(std::vector<std::uint32_t> corners, std::size_t mode) {
    constexpr std::size_t list = 4, strip = 5;
    if (mode == list) {
        corners.resize(corners.size() / 3 * 3);
        return corners;
    }
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const std::size_t odd = i % 2;
        if (mode == strip) {
            out.insert(out.end(), {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
        } else {
            out.insert(out.end(), {corners[i + 1], corners[i + 2], corners[0]});
        }
    }
    return out;
}

struct Influence {
    std::vector<glm::uvec4> joints;
    std::vector<glm::vec4> weights;
};

/// A mesh's primitives as they stand in the file.
struct Primitive {
    GivenMesh mesh;
    std::vector<Influence> influences; ///< four joints each
    std::size_t material = 0;
};

class Meshes {
  public:
    Meshes(const GltfFile& file, const std::vector<GltfMaterial>& materials,
           const std::vector<glm::mat4>& places, Scene& scene, LeftOut& left_out)
        : file_(file), materials_(materials), places_(places), scene_(scene), left_out_(left_out) {}

    void run() {
        for (const std::size_t node : gltf_shown_nodes(file_)) {
            const json& row = file_.list("nodes")[node];
            gltf_extensions(row, "nodes'", {"KHR_lights_punctual"}, left_out_);
            const auto mesh = file_.index(row, "mesh", "meshes");
            if (!mesh || places_[node] == glm::mat4(0)) {
                continue;
            }
            if (const auto skin = file_.index(row, "skin", "skins")) {
                show_skinned(*mesh, *skin);
            } else {
                show(shared_meshes(*mesh), places_[node]);
            }
        }
    }

  private:
    struct Shown {
        std::uint32_t mesh, material;
    };

    void show(const std::vector<Shown>& meshes, const glm::mat4& place) {
        for (const Shown& shown : meshes) {
            if (scene_.objects.size() == import_limits.nodes) {
                file_.refuse(fmt::format("it has more than {} objects, which is the limit",
                                         import_limits.nodes));
            }
            // Light falls through what is blended.
            const bool casts = !materials_[shown.material].material.detail.is_blended;
            scene_.objects.push_back({shown.mesh, shown.material, place, casts});
        }
    }

    /// The node's own place counts for nothing, as glTF 2.0, 3.7.3.3, has it.
    void show_skinned(std::size_t mesh, std::size_t skin) {
        left_out_.add("skins (in their bind pose)", skins_seen_[skin]++ == 0 ? 1 : 0);
        const std::vector<glm::mat4> joints = joints_of(skin);
        std::vector<Shown> shown;
        for (Primitive primitive : primitives_of(mesh)) {
            bend(primitive, joints);
            add(primitive, shown);
        }
        show(shown, glm::mat4(1));
    }

    const std::vector<Shown>& shared_meshes(std::size_t mesh) {
        const auto [known, is_new] = shared_.try_emplace(mesh);
        if (is_new) {
            for (const Primitive& primitive : primitives_of(mesh)) {
                add(primitive, known->second);
            }
        }
        return known->second;
    }

    void add(const Primitive& primitive, std::vector<Shown>& shown) {
        Mesh mesh = mesh_of(primitive.mesh, left_out_);
        vertices_ += mesh.vertices.size();
        if (vertices_ > import_limits.vertices) {
            file_.refuse(fmt::format("it has more than {} vertices, which is the limit",
                                     import_limits.vertices));
        }
        if (mesh.indices.empty()) {
            return;
        }
        shown.push_back({static_cast<std::uint32_t>(scene_.meshes.size()),
                         static_cast<std::uint32_t>(primitive.material)});
        scene_.meshes.push_back(std::move(mesh));
    }

    std::vector<Primitive> primitives_of(std::size_t mesh) {
        std::vector<Primitive> out;
        const json& row = file_.list("meshes")[mesh];
        for (const json& given : file_.list(row, "primitives")) {
            const std::size_t mode = file_.count(given, "mode", 4);
            const json& attributes = gltf_object(given, "attributes");
            if (mode < 4 || mode > 6 || !attributes.contains("POSITION")) {
                left_out_.add("meshes of points or lines");
                continue;
            }
            out.push_back(primitive_of(given, attributes, mode));
            out.back().mesh.name = printable(gltf_text(row, "name"));
        }
        return out;
    }

    Primitive primitive_of(const json& given, const json& attributes, std::size_t mode) {
        gltf_extensions(given, "meshes'", {}, left_out_);
        left_out_.add("morph targets (the rest pose is shown)",
                      file_.list(given, "targets").size());
        Primitive out;
        out.material = file_.index(given, "material", "materials").value_or(materials_.size() - 1);
        const GltfMaterial& material = materials_[out.material];
        const MaterialDetail& detail = material.material.detail;
        GivenMesh& mesh = out.mesh;
        mesh.is_double_sided = material.is_double_sided;
        mesh.positions = attribute<glm::vec3>(file_, attributes, "POSITION");
        mesh.normals = attribute<glm::vec3>(file_, attributes, "NORMAL");
        mesh.colors = colors_of(file_, attributes);
        for (const TextureUse* use :
             {&detail.base, &detail.surface, &detail.normal, &detail.occlusion, &detail.emission}) {
            if (use->texture != TextureUse::none && mesh.uv[use->uv_set].empty()) {
                mesh.uv[use->uv_set] = attribute<glm::vec2>(
                    file_, attributes, "TEXCOORD_" + std::to_string(material.uv_sets[use->uv_set]));
            }
        }
        if (detail.normal.texture != TextureUse::none) {
            mesh.needs_tangents = true;
            mesh.tangent_uv = detail.normal.uv_set;
            mesh.tangents = attribute<glm::vec4>(file_, attributes, "TANGENT");
        }
        mesh.indices = triangles_of(corners_of(given, mesh.positions.size()), mode);
        check_counts(mesh);
        read_influences(attributes, mesh.positions.size(), out.influences);
        return out;
    }

    std::vector<std::uint32_t> corners_of(const json& given, std::size_t vertices) const {
        if (const auto accessor = file_.index(given, "indices", "accessors")) {
            return gltf_words(file_, *accessor, 1);
        }
        std::vector<std::uint32_t> all(vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            all[i] = static_cast<std::uint32_t>(i);
        }
        return all;
    }

    void check_counts(const GivenMesh& mesh) const {
        for (const std::size_t count :
             {mesh.normals.size(), mesh.colors.size(), mesh.tangents.size(), mesh.uv[0].size(),
              mesh.uv[1].size()}) {
            if (count != 0 && count != mesh.positions.size()) {
                file_.refuse("a mesh has not as many normals, colours or texture coordinates as "
                             "positions");
            }
        }
    }

    void read_influences(const json& attributes, std::size_t vertices,
                         std::vector<Influence>& out) const {
        for (int set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
            const auto joints =
                file_.index(attributes, ("JOINTS_" + std::to_string(set)).c_str(), "accessors");
            const std::vector<std::uint32_t> words = gltf_words(file_, *joints, 4);
            Influence influence;
            for (std::size_t i = 0; i + 3 < words.size(); i += 4) {
                influence.joints.emplace_back(words[i], words[i + 1], words[i + 2], words[i + 3]);
            }
            influence.weights =
                attribute<glm::vec4>(file_, attributes, "WEIGHTS_" + std::to_string(set));
            if (influence.joints.size() != vertices || influence.weights.size() != vertices) {
                file_.refuse("a mesh has not as many joints and weights as positions");
            }
            out.push_back(std::move(influence));
        }
    }

    /// A joint's place times the inverse of where it was when the skin was bound.
    std::vector<glm::mat4> joints_of(std::size_t skin) const {
        const json& row = file_.list("skins")[skin];
        std::vector<glm::mat4> bound;
        if (const auto accessor = file_.index(row, "inverseBindMatrices", "accessors")) {
            const std::vector<float> numbers = gltf_floats(file_, *accessor, 16);
            for (std::size_t i = 0; i + 15 < numbers.size(); i += 16) {
                glm::mat4& matrix = bound.emplace_back();
                for (std::size_t j = 0; j < 16; ++j) {
                    matrix[static_cast<int>(j / 4)][static_cast<int>(j % 4)] = numbers[i + j];
                }
            }
        }
        std::vector<glm::mat4> out;
        for (const json& joint : row.value("joints", json::array())) {
            if (!joint.is_number_unsigned() || joint.get<std::size_t>() >= places_.size()) {
                file_.refuse("a skin names a joint that does not exist");
            }
            const glm::mat4& place = places_[joint.get<std::size_t>()];
            out.push_back(out.size() < bound.size() ? place * bound[out.size()] : place);
        }
        return out;
    }

    void bend(Primitive& primitive, const std::vector<glm::mat4>& joints) const {
        GivenMesh& mesh = primitive.mesh;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            glm::mat4 sum(0);
            float weight = 0;
            for (const Influence& influence : primitive.influences) {
                for (int j = 0; j < 4; ++j) {
                    const std::uint32_t joint = influence.joints[i][j];
                    if (joint >= joints.size()) {
                        file_.refuse("a vertex names a joint that does not exist");
                    }
                    sum += influence.weights[i][j] * joints[joint];
                    weight += influence.weights[i][j];
                }
            }
            sum = weight > 0 ? sum / weight : glm::mat4(1);
            mesh.positions[i] = glm::vec3(sum * glm::vec4(mesh.positions[i], 1));
            if (!mesh.normals.empty()) {
                const glm::vec3 turned = glm::mat3(sum) * mesh.normals[i];
                const float length = glm::length(turned);
                mesh.normals[i] = length > 0 ? turned / length : turned;
            }
            if (!mesh.tangents.empty()) {
                mesh.tangents[i] =
                    glm::vec4(glm::mat3(sum) * glm::vec3(mesh.tangents[i]), mesh.tangents[i].w);
            }
        }
    }

    const GltfFile& file_;
    const std::vector<GltfMaterial>& materials_;
    const std::vector<glm::mat4>& places_;
    Scene& scene_;
    LeftOut& left_out_;
    std::map<std::size_t, std::vector<Shown>> shared_;
    std::map<std::size_t, std::size_t> skins_seen_;
    std::size_t vertices_ = 0;
};

} // namespace

void gltf_meshes(const GltfFile& file, const std::vector<GltfMaterial>& materials,
                 const std::vector<glm::mat4>& places, Scene& scene, LeftOut& left_out) {
    Meshes(file, materials, places, scene, left_out).run();
}

} // namespace preview
