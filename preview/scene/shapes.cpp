#include "preview/scene/shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace preview {

namespace {

/// Runs of points without a corner inside, as [first, last].
std::vector<std::pair<std::size_t, std::size_t>> runs_of(std::span<const glm::vec2> points) {
    std::vector<std::pair<std::size_t, std::size_t>> out;
    std::size_t first = 0;
    for (std::size_t i = 1; i <= points.size(); ++i) {
        if (i == points.size() || points[i] == points[i - 1]) {
            if (i - first > 1) {
                out.emplace_back(first, i - 1);
            }
            first = i;
        }
    }
    return out;
}

} // namespace

Mesh lathe(std::span<const glm::vec2> profile, int sectors) {
    Mesh mesh;
    mesh.name = "lathe";
    float whole = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        whole += glm::distance(profile[i - 1], profile[i]);
    }
    float walked = 0;
    for (const auto& [first, last] : runs_of(profile)) {
        const auto begin = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t i = first; i <= last; ++i) {
            walked += i > first ? glm::distance(profile[i - 1], profile[i]) : 0;
            const glm::vec2 along =
                glm::normalize(profile[i == last ? i : i + 1] - profile[i == first ? i : i - 1]);
            for (int sector = 0; sector <= sectors; ++sector) {
                const float turn = static_cast<float>(sector) / static_cast<float>(sectors);
                const float angle = 2 * std::numbers::pi_v<float> * turn;
                const glm::vec3 out(std::cos(angle), 0, -std::sin(angle));
                const glm::vec3 up(0, 1, 0);
                mesh.vertices.push_back(
                    {profile[i].x * out + profile[i].y * up, along.y * out - along.x * up});
                VertexDetail detail;
                detail.uv[0] = {turn, 1 - walked / whole};
                detail.tangent = {-std::sin(angle), 0, -std::cos(angle), 1};
                mesh.details.push_back(detail);
            }
        }
        add_grid(mesh, begin, static_cast<int>(last - first), sectors);
    }
    return mesh;
}

std::vector<glm::vec2> smoothed(std::span<const glm::vec2> points, int steps) {
    std::vector<glm::vec2> out;
    for (const auto& [first, last] : runs_of(points)) {
        for (std::size_t i = first; i < last; ++i) {
            const glm::vec2 a = points[i == first ? i : i - 1];
            const glm::vec2 b = points[i];
            const glm::vec2 c = points[i + 1];
            const glm::vec2 d = points[i + 1 == last ? i + 1 : i + 2];
            for (int step = 0; step < steps; ++step) {
                const float t = static_cast<float>(step) / static_cast<float>(steps);
                const glm::vec2 p =
                    b +
                    0.5F * t *
                        (c - a +
                         t * (2.0F * a - 5.0F * b + 4.0F * c - d + t * (3.0F * (b - c) + d - a)));
                out.push_back({std::max(p.x, 0.0F), p.y});
            }
        }
        out.push_back(points[last]);
    }
    return out;
}

Mesh surface(int columns, int rows, const std::function<glm::vec3(glm::vec2)>& position) {
    Mesh mesh;
    mesh.name = "surface";
    constexpr float step = 1e-3F;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const glm::vec2 at(static_cast<float>(column) / static_cast<float>(columns),
                               static_cast<float>(row) / static_cast<float>(rows));
            const glm::vec2 low = glm::max(at - step, glm::vec2(0));
            const glm::vec2 high = glm::min(at + step, glm::vec2(1));
            const glm::vec3 du = position({high.x, at.y}) - position({low.x, at.y});
            const glm::vec3 dv = position({at.x, high.y}) - position({at.x, low.y});
            const glm::vec3 normal = glm::normalize(glm::cross(dv, du));
            mesh.vertices.push_back({position(at), normal});
            VertexDetail detail;
            detail.uv[0] = at;
            detail.tangent = glm::vec4(glm::normalize(du - normal * glm::dot(normal, du)), 1);
            mesh.details.push_back(detail);
        }
    }
    add_grid(mesh, 0, rows, columns);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    return mesh;
}

Mesh two_sided(Mesh mesh) {
    const auto vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::size_t indices = mesh.indices.size();
    for (std::uint32_t i = 0; i < vertices; ++i) {
        mesh.vertices.push_back({mesh.vertices[i].position, -mesh.vertices[i].normal});
        if (!mesh.details.empty()) {
            mesh.details.push_back(mesh.details[i]);
            mesh.details.back().tangent.w *= -1;
        }
    }
    for (std::size_t i = 0; i < indices; i += 3) {
        for (const std::size_t corner : {0U, 2U, 1U}) {
            mesh.indices.push_back(mesh.indices[i + corner] + vertices);
        }
    }
    return mesh;
}

void paint(Mesh& mesh, const std::function<glm::vec3(const Vertex&)>& color) {
    mesh.details.resize(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.details[i].color = glm::vec4(color(mesh.vertices[i]), 1);
    }
}

void repeat(Mesh& mesh, glm::vec2 times) {
    for (VertexDetail& detail : mesh.details) {
        detail.uv[0] *= times;
    }
}

} // namespace preview
