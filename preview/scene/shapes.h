// Meshes with texture coordinates: what is turned on a lathe, and surfaces from formulas. As the
// meshes of mesh.h, with a detail a vertex; seen from its front a picture on them is upright and
// not mirrored.
#pragma once

#include "preview/scene/mesh.h"

#include <functional>

namespace preview {

/// (radius, height) points turned about y. The outside lies to the right of one who walks along the
/// profile: up the outside, down the inside. Normals are smooth but where a point is given twice.
/// u runs round, v from the profile's end to its beginning by length, both 0..1.
Mesh lathe(std::span<const glm::vec2> profile, int sectors);

/// Points on smooth curves (Catmull and Rom 1974) through the given ones, `steps` from each to the
/// next; a point given twice is a corner.
std::vector<glm::vec2> smoothed(std::span<const glm::vec2> points, int steps);

/// position(u, v) over 0..1 x 0..1; the front is where u runs to the right and v down. Normals are
/// those of the formula, by differences.
Mesh surface(int columns, int rows, const std::function<glm::vec3(glm::vec2)>& position);

/// The mesh with its back as a second surface.
Mesh two_sided(Mesh mesh);

/// Gives every vertex a colour, linear, by its place.
void paint(Mesh& mesh, const std::function<glm::vec3(const Vertex&)>& color);

/// Scales the first texture coordinates.
void repeat(Mesh& mesh, glm::vec2 times);

} // namespace preview
