#include "preview/scene/mesh.h"

#include "preview/scene/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace preview {

namespace {

// Sweeps a circle of radius `tube` along the closed curve centre(t), t in 0..1. The frame is made
// from the tangent and `axis(t)`, which never points along the tangent.
template <class Centre, class Axis>
Mesh tube_along(float tube, int segments, int sides, Centre centre, Axis axis) {
    Mesh mesh;
    for (int i = 0; i <= segments; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(segments);
        const float step = 1e-3F;
        const glm::vec3 tangent = glm::normalize(centre(t + step) - centre(t - step));
        const glm::vec3 across = glm::normalize(glm::cross(axis(t), tangent));
        const glm::vec3 up = glm::cross(tangent, across);
        for (int j = 0; j <= sides; ++j) {
            const float angle = 2 * pi * static_cast<float>(j) / static_cast<float>(sides);
            const glm::vec3 normal = across * std::cos(angle) + up * std::sin(angle);
            mesh.vertices.push_back({centre(t) + tube * normal, normal});
        }
    }
    add_grid(mesh, 0, segments, sides);
    return mesh;
}

} // namespace

void add_grid(Mesh& mesh, std::uint32_t first, int rows, int columns) {
    const auto width = static_cast<std::uint32_t>(columns) + 1;
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
        for (std::uint32_t column = 0; column + 1 < width; ++column) {
            const std::uint32_t corner = first + row * width + column;
            for (const std::uint32_t step : {0u, 1u, width + 1, 0u, width + 1, width}) {
                mesh.indices.push_back(corner + step);
            }
        }
    }
}

void Bounds::include(glm::vec3 point) {
    if (empty()) {
        min = max = point;
        return;
    }
    min = glm::min(min, point);
    max = glm::max(max, point);
}

void Bounds::include(const Bounds& box, const glm::mat4& transform) {
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                          (corner & 2) != 0 ? box.max.y : box.min.y,
                          (corner & 4) != 0 ? box.max.z : box.min.z, 1};
        include(glm::vec3{transform * p});
    }
}

Bounds bounds_of(const Mesh& mesh) {
    Bounds bounds;
    for (const Vertex& vertex : mesh.vertices) {
        bounds.include(vertex.position);
    }
    return bounds;
}

Mesh sphere(int rings, int sectors) {
    Mesh mesh;
    mesh.name = "sphere";
    for (int ring = 0; ring <= rings; ++ring) {
        const float polar = pi * static_cast<float>(ring) / static_cast<float>(rings);
        for (int sector = 0; sector <= sectors; ++sector) {
            const float angle = 2 * pi * static_cast<float>(sector) / static_cast<float>(sectors);
            const glm::vec3 p{std::sin(polar) * std::cos(angle), std::cos(polar),
                              -std::sin(polar) * std::sin(angle)};
            mesh.vertices.push_back({p, p});
        }
    }
    // The grid runs down and around, so that its first diagonal makes the outer side the front.
    add_grid(mesh, 0, rings, sectors);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    return mesh;
}

Mesh torus(float tube, int segments, int sides) {
    Mesh mesh = tube_along(
        tube, segments, sides,
        [](float t) {
            return glm::vec3{std::cos(2 * pi * t), 0, -std::sin(2 * pi * t)};
        },
        [](float) {
            return glm::vec3{0, 1, 0};
        });
    mesh.name = "torus";
    return mesh;
}

Mesh torus_knot(int p, int q, float minor, float tube, int segments, int sides) {
    const auto around = [=](float t) { return 2 * pi * static_cast<float>(p) * t; };
    const auto through = [=](float t) { return 2 * pi * static_cast<float>(q) * t; };
    Mesh mesh = tube_along(
        tube, segments, sides,
        [=](float t) {
            const float radius = 1 + minor * std::cos(through(t));
            return glm::vec3{radius * std::cos(around(t)), minor * std::sin(through(t)),
                             -radius * std::sin(around(t))};
        },
        // The normal of the torus that carries the knot: always across the curve.
        [=](float t) {
            return glm::vec3{std::cos(through(t)) * std::cos(around(t)), std::sin(through(t)),
                             -std::cos(through(t)) * std::sin(around(t))};
        });
    mesh.name = "torus-knot";
    return mesh;
}

Mesh box(glm::vec3 half, float radius, int steps) {
    Mesh mesh;
    mesh.name = "box";
    radius = std::min({radius, half.x, half.y, half.z});
    if (radius <= 0) {
        radius = 0;
        steps = 0;
    }
    const glm::vec3 inner = half - radius;

    // One axis of a face: which inner edge, and the tangent of the angle by which the rounding
    // leans outwards there.
    struct Stop {
        float side, lean;
    };
    std::vector<Stop> stops;
    for (int i = -steps; i <= steps; ++i) {
        const float lean =
            steps == 0
                ? 0
                : std::tan(pi / 4 * static_cast<float>(i < 0 ? -i : i) / static_cast<float>(steps));
        if (i <= 0) {
            stops.push_back({-1, lean});
        }
        if (i >= 0) {
            stops.push_back({1, lean});
        }
    }
    const int cells = static_cast<int>(stops.size()) - 1;
    for (int face = 0; face < 6; ++face) {
        const int w = face / 2, u = (w + 1) % 3, v = (w + 2) % 3;
        const float sign = face % 2 == 0 ? 1.0F : -1.0F;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Stop& a : stops) {
            for (const Stop& b : stops) {
                glm::vec3 corner, normal;
                corner[w] = sign * inner[w];
                corner[u] = sign * a.side * inner[u];
                corner[v] = b.side * inner[v];
                normal[w] = sign;
                normal[u] = sign * a.side * a.lean;
                normal[v] = b.side * b.lean;
                normal = glm::normalize(normal);
                mesh.vertices.push_back({corner + radius * normal, normal});
            }
        }
        add_grid(mesh, first, cells, cells);
        for (std::size_t i = mesh.indices.size() - static_cast<std::size_t>(cells * cells) * 6;
             i < mesh.indices.size(); i += 3) {
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
        }
    }
    return mesh;
}

Mesh cylinder(int sectors) {
    Mesh mesh;
    mesh.name = "cylinder";
    const auto ring = [&](float radius, float y, auto normal_at) {
        for (int i = 0; i <= sectors; ++i) {
            const float angle = 2 * pi * static_cast<float>(i) / static_cast<float>(sectors);
            const glm::vec3 out{std::cos(angle), 0, -std::sin(angle)};
            mesh.vertices.push_back({radius * out + glm::vec3{0, y, 0}, normal_at(out)});
        }
    };
    const glm::vec3 up{0, 1, 0};
    const auto band = [&](float r0, float y0, float r1, float y1, auto normal_at) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        ring(r0, y0, normal_at);
        ring(r1, y1, normal_at);
        add_grid(mesh, first, 1, sectors);
    };
    band(0, -1, 1, -1, [&](glm::vec3) { return -up; });
    band(1, -1, 1, 1, [&](glm::vec3 out) { return out; });
    band(1, 1, 0, 1, [&](glm::vec3) { return up; });
    return mesh;
}

Mesh plane() {
    constexpr std::array<glm::vec2, 2> profile{glm::vec2{1, 0}, glm::vec2{-1, 0}};
    Mesh mesh = extrude(profile, 1);
    mesh.name = "plane";
    return mesh;
}

Mesh extrude(std::span<const glm::vec2> profile, float half_width) {
    Mesh mesh;
    mesh.name = "extrusion";
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const glm::vec2 before = profile[i == 0 ? 0 : i - 1];
        const glm::vec2 after = profile[i + 1 == profile.size() ? i : i + 1];
        const glm::vec2 tangent = glm::normalize(after - before);
        const glm::vec3 normal{0, -tangent.x, tangent.y};
        for (const float x : {-half_width, half_width}) {
            mesh.vertices.push_back({{x, profile[i].y, profile[i].x}, normal});
        }
    }
    add_grid(mesh, 0, static_cast<int>(profile.size()) - 1, 1);
    return mesh;
}

} // namespace preview
