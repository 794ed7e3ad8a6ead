#include "preview/scene/import_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace preview {

namespace {

bool is_usable(const glm::vec3& v) {
    return std::abs(v.x) < most_coordinate && std::abs(v.y) < most_coordinate &&
           std::abs(v.z) < most_coordinate; // false for NaN
}

template <class V>
V finite(V v) {
    for (int i = 0; i < V::length(); ++i) {
        v[i] = std::abs(v[i]) < most_coordinate ? v[i] : 0.0F;
    }
    return v;
}

struct Triangle {
    std::uint32_t indices[3]{};
    glm::vec3 corners[3]{};
    glm::vec3 flat{0};           ///< its own normal
    glm::vec3 tangent{0};        ///< towards growing u, not unit
    bool is_left_handed = false; ///< v grows along normal x tangent
};

class MeshImport {
  public:
    MeshImport(const GivenMesh& given, LeftOut& left_out) : given_(given), left_out_(left_out) {
        has_detail_ = !given.uv[0].empty() || !given.uv[1].empty() || !given.colors.empty();
        makes_tangents_ = given.needs_tangents && (given.tangents.empty() || given.normals.empty());
    }

    Mesh run() {
        out_.name = given_.name;
        for (std::size_t at = 0; at + 2 < given_.indices.size(); at += 3) {
            add(given_.indices.data() + at);
        }
        for (const Triangle& triangle : triangles_) {
            sum_tangents(triangle);
        }
        for (const Triangle& triangle : triangles_) {
            emit(triangle, {0, 1, 2}, false);
            if (given_.is_double_sided) {
                emit(triangle, {0, 2, 1}, true);
            }
        }
        return std::move(out_);
    }

  private:
    void add(const std::uint32_t* indices) {
        Triangle out;
        for (std::size_t i = 0; i < 3; ++i) {
            out.indices[i] = indices[i];
            if (indices[i] >= given_.positions.size() || !is_usable(given_.positions[indices[i]])) {
                left_out_.add("triangles with a missing or non-finite vertex");
                return;
            }
            out.corners[i] = given_.positions[indices[i]];
        }
        const glm::vec3 across =
            glm::cross(out.corners[1] - out.corners[0], out.corners[2] - out.corners[0]);
        const float area = glm::length(across);
        if (!(area > 0)) {
            return; // nobody could see it
        }
        out.flat = across / area;
        triangles_.push_back(out);
        set_tangent(triangles_.back());
    }

    /// Lengyel 2001, "Computing tangent space basis vectors for an arbitrary mesh".
    void set_tangent(Triangle& triangle) const {
        const std::vector<glm::vec2>& uv = given_.uv[given_.tangent_uv];
        if (!makes_tangents_ || uv.empty()) {
            return;
        }
        const glm::vec3 e1 = triangle.corners[1] - triangle.corners[0];
        const glm::vec3 e2 = triangle.corners[2] - triangle.corners[0];
        const glm::vec2 d1 = uv[triangle.indices[1]] - uv[triangle.indices[0]];
        const glm::vec2 d2 = uv[triangle.indices[2]] - uv[triangle.indices[0]];
        const float area = d1.x * d2.y - d2.x * d1.y;
        const glm::vec3 along = (e1 * d2.y - e2 * d1.y) * (area < 0 ? -1.0F : 1.0F);
        const float length = glm::length(along);
        if (std::isfinite(length) && length > 0) {
            triangle.tangent = along / length;
        }
        // normal x tangent points up in the picture, where v falls.
        triangle.is_left_handed = area > 0;
    }

    /// Mikkelsen 2008 weights a corner by its angle.
    void sum_tangents(const Triangle& triangle) {
        if (!makes_tangents_) {
            return;
        }
        std::vector<glm::vec3>& sums = tangents_[triangle.is_left_handed ? 1 : 0];
        sums.resize(given_.positions.size(), glm::vec3(0));
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 a = triangle.corners[(i + 1) % 3] - triangle.corners[i];
            const glm::vec3 b = triangle.corners[(i + 2) % 3] - triangle.corners[i];
            const float angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            sums[triangle.indices[i]] += angle * triangle.tangent;
        }
    }

    void emit(const Triangle& triangle, const std::size_t (&order)[3], bool is_back) {
        for (const std::size_t i : order) {
            out_.indices.push_back(vertex(triangle, i, is_back));
        }
    }

    /// The index of a corner; those with a normal of their own are shared between triangles.
    std::uint32_t vertex(const Triangle& triangle, std::size_t corner, bool is_back) {
        const std::uint32_t index = triangle.indices[corner];
        const glm::vec3 given = given_.normals.empty() ? glm::vec3(0) : given_.normals[index];
        const float length = glm::length(given);
        const bool has_normal = length > 0.01F && length < 100;
        std::vector<std::uint32_t>& shared =
            shared_[(is_back ? 2 : 0) + (triangle.is_left_handed ? 1 : 0)];
        if (has_normal) {
            shared.resize(given_.positions.size(), unknown);
            if (shared[index] != unknown) {
                return shared[index];
            }
        }
        const auto at = static_cast<std::uint32_t>(out_.vertices.size());
        const glm::vec3 normal = has_normal ? given / length : triangle.flat;
        const float side = is_back ? -1.0F : 1.0F;
        out_.vertices.push_back({triangle.corners[corner], side * normal});
        if (has_detail_) {
            out_.details.push_back(detail(triangle, index, normal, side));
        }
        if (has_normal) {
            shared[index] = at;
        }
        return at;
    }

    VertexDetail detail(const Triangle& triangle, std::uint32_t index, glm::vec3 normal,
                        float side) const {
        VertexDetail out;
        for (std::size_t set = 0; set < 2; ++set) {
            if (!given_.uv[set].empty()) {
                out.uv[set] = finite(given_.uv[set][index]);
            }
        }
        if (!given_.colors.empty()) {
            out.color = glm::clamp(finite(given_.colors[index]), 0.0F, 1.0F);
        }
        if (!given_.needs_tangents) {
            return out;
        }
        const std::size_t hand = triangle.is_left_handed ? 1 : 0;
        glm::vec4 tangent = makes_tangents_ ? glm::vec4(tangents_[hand][index],
                                                        triangle.is_left_handed ? -1.0F : 1.0F)
                                            : finite(given_.tangents[index]);
        glm::vec3 along(tangent);
        along -= normal * glm::dot(normal, along);
        if (const float length = glm::length(along); length > 1e-6F) {
            // A back is the front seen from behind: its whole frame turns round.
            out.tangent = glm::vec4(side * along / length, side * (tangent.w < 0 ? -1.0F : 1.0F));
        }
        return out;
    }

    static constexpr std::uint32_t unknown = UINT32_MAX;
    const GivenMesh& given_;
    LeftOut& left_out_;
    bool has_detail_ = false, makes_tangents_ = false;
    Mesh out_;
    std::vector<Triangle> triangles_;
    std::vector<glm::vec3> tangents_[2];   ///< sums by the given index, right- and left-handed
    std::vector<std::uint32_t> shared_[4]; ///< by the given index, for back and handedness
};

} // namespace

Mesh mesh_of(const GivenMesh& given, LeftOut& left_out) {
    return MeshImport(given, left_out).run();
}

} // namespace preview
