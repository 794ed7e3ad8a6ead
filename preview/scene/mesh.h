// Triangle meshes made from formulas: what the built-in scenes consist of. No Vulkan.
//
// Right-handed, y up, metres. Front faces wind counter-clockwise seen from outside; normals have
// unit length and point outwards.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

namespace preview {

struct Vertex {
    glm::vec3 position{0};
    glm::vec3 normal{0, 1, 0};
};

/// What textures and vertex colours need besides.
struct VertexDetail {
    glm::vec2 uv[2]{};    ///< (0, 0) is a picture's upper left corner; the material says which set
    glm::vec4 color{1};   ///< linear, 0..1; times the base colour
    glm::vec4 tangent{0}; ///< unit, towards growing u; w: -1 where v grows along normal x tangent
};

struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<VertexDetail> details{}; ///< empty, or one a vertex
    std::vector<std::uint32_t> indices;  ///< three a triangle
};

/// An axis-aligned box; empty while min exceeds max.
struct Bounds {
    glm::vec3 min{1}, max{-1};

    bool empty() const { return min.x > max.x; }
    void include(glm::vec3 point);
    /// The corners of a box, carried by `transform`.
    void include(const Bounds& box, const glm::mat4& transform);
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Lists two triangles for each cell of a grid of (rows + 1) x (columns + 1) vertices from `first`
/// on. Their front is where columns grow to the right and rows upwards.
void add_grid(Mesh& mesh, std::uint32_t first, int rows, int columns);

Bounds bounds_of(const Mesh& mesh);

/// Radius 1 about the origin, `rings` from pole to pole, `sectors` around; rings >= 2, sectors
/// >= 3.
Mesh sphere(int rings, int sectors);

/// A tube of radius `tube` about the circle of radius 1 in the plane y = 0.
Mesh torus(float tube, int segments, int sides);

/// A tube of radius `tube` along the (p,q) torus knot on a torus of radii 1 and `minor`, about y.
Mesh torus_knot(int p, int q, float minor, float tube, int segments, int sides);

/// The box of half sizes `half` about the origin with edges rounded by `radius` (0: sharp).
Mesh box(glm::vec3 half, float radius, int steps = 4);

/// Upright about y, radius 1, height from -1 to 1, closed at both ends.
Mesh cylinder(int sectors);

/// The square of half side 1 in the plane y = 0, facing up.
Mesh plane();

/// A profile of (z, y) points drawn along x from -half_width to half_width, with normals that are
/// smooth along it. A profile that walks towards -z gives a surface that faces up.
Mesh extrude(std::span<const glm::vec2> profile, float half_width);

} // namespace preview
