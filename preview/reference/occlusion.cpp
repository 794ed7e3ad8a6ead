#include "preview/reference/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tbb/parallel_for.h>

namespace preview::reference {

namespace {

constexpr double golden = 0.61803398875;

/// Jarzynski and Olano 2020, "Hash functions for GPU rendering".
std::array<std::uint32_t, 3> pcg3d(std::array<std::uint32_t, 3> v) {
    for (std::uint32_t& word : v) {
        word = word * 1664525U + 1013904223U;
    }
    const auto mix = [&] {
        v[0] += v[1] * v[2];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
    };
    mix();
    for (std::uint32_t& word : v) {
        word ^= word >> 16U;
    }
    mix();
    return v;
}

double unit_of(std::uint32_t bits) {
    return (bits >> 8U) / 16777216.0;
}

std::uint32_t reversed(std::uint32_t bits) {
    std::uint32_t out = 0;
    for (int i = 0; i < 32; ++i) {
        out = out << 1U | (bits >> static_cast<unsigned>(i) & 1U);
    }
    return out;
}

double fraction(double v) {
    return v - std::floor(v);
}

struct Frame {
    glm::dvec3 tangent, bitangent, normal;
    /// Of a cosine-weighted hemisphere: `share` and `turn` even in 0..1.
    glm::dvec3 direction(double share, double turn) const {
        const double angle = 2 * std::numbers::pi * turn;
        return std::sqrt(share) * (std::cos(angle) * tangent + std::sin(angle) * bitangent) +
               std::sqrt(1 - share) * normal;
    }
};

Frame frame_about(glm::dvec3 normal) {
    const glm::dvec3 a = glm::abs(normal);
    constexpr double same = 1e-3;
    const glm::dvec3 axis = a.x <= a.y + same && a.x <= a.z + same ? glm::dvec3(1, 0, 0)
                            : a.y <= a.z + same                    ? glm::dvec3(0, 1, 0)
                                                                   : glm::dvec3(0, 0, 1);
    const glm::dvec3 tangent = glm::normalize(glm::cross(normal, axis));
    return {tangent, glm::cross(normal, tangent), normal};
}

glm::dvec3 ray_at(const SeenSurfaces& seen, int x, int y) {
    return glm::dvec3(seen.view.forward) +
           ((x + 0.5) / seen.width * 2 - 1) * glm::dvec3(seen.view.right) +
           ((y + 0.5) / seen.height * 2 - 1) * glm::dvec3(seen.view.up);
}

double z_at(const SeenSurfaces& seen, int x, int y) {
    return static_cast<double>(seen.view.position_near.w) /
           (1 - static_cast<double>(seen.depth[seen.index(x, y)]));
}

/// Whether what the picture shows in front of a point hides it from the pixel at `position`.
bool is_hidden(const SeenSurfaces& seen, double radius, glm::dvec3 position, glm::dvec3 normal,
               glm::dvec3 point) {
    const double z = glm::dot(point, glm::dvec3(seen.view.forward));
    if (!(z > static_cast<double>(seen.view.position_near.w))) {
        return false;
    }
    const auto place = [&](glm::dvec3 axis, int size) {
        const double screen = glm::dot(point, axis) / glm::dot(axis, axis) / z;
        return std::floor((screen * 0.5 + 0.5) * size);
    };
    const double x = place(glm::dvec3(seen.view.right), seen.width);
    const double y = place(glm::dvec3(seen.view.up), seen.height);
    if (x < 0 || y < 0 || x >= seen.width || y >= seen.height ||
        !seen.shows(static_cast<int>(x), static_cast<int>(y))) {
        return false;
    }
    const double gap = z - z_at(seen, static_cast<int>(x), static_cast<int>(y));
    const glm::dvec3 surface = seen.position(static_cast<int>(x), static_cast<int>(y));
    return gap > 0 && gap < 2 * radius && glm::dot(normal, surface - position) > 0.01 * radius;
}

} // namespace

glm::dvec3 octahedral_normal(double x, double y) {
    const double u = x / 32767 - 1, v = y / 32767 - 1;
    glm::dvec3 out(u, v, 1 - std::abs(u) - std::abs(v));
    if (out.z < 0) { // the lower half is folded outwards
        out.x = (1 - std::abs(v)) * (u < 0 ? -1 : 1);
        out.y = (1 - std::abs(u)) * (v < 0 ? -1 : 1);
    }
    return glm::normalize(out);
}

bool SeenSurfaces::shows(int x, int y) const {
    return depth[index(x, y)] < 1;
}

glm::dvec3 SeenSurfaces::position(int x, int y) const {
    return ray_at(*this, x, y) * z_at(*this, x, y);
}

namespace {

/// One value for each cell of pixels.
struct Cells {
    int width = 0, height = 0;
    std::vector<double> values;

    Cells(const SeenSurfaces& seen, int side)
        : width((seen.width + side - 1) / side), height((seen.height + side - 1) / side),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1) {}
    double& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// How far a pixel's surface lies in the tangent plane of another's, 1 to 0.
double shares_plane(const SeenSurfaces& seen, const OcclusionModel& model, int x, int y, int to_x,
                    int to_y) {
    if (!seen.shows(to_x, to_y)) {
        return 0;
    }
    const double away = std::abs(
        glm::dot(seen.normal[seen.index(x, y)], seen.position(to_x, to_y) - seen.position(x, y)));
    return std::max(1 - away / (0.1 * model.radius), 0.0);
}

/// Of one pixel; `bits` are its offsets.
double occlusion_at(const SeenSurfaces& seen, const OcclusionModel& model, int x, int y,
                    const std::array<std::uint32_t, 3>& bits) {
    const glm::dvec3 position = seen.position(x, y);
    const Frame frame = frame_about(seen.normal[seen.index(x, y)]);
    int hidden = 0;
    for (int i = 0; i < model.samples; ++i) {
        const double share = (i + unit_of(bits[0])) / model.samples;
        const double turn = fraction(i * golden + unit_of(bits[1]));
        const double reach =
            fraction(unit_of(reversed(static_cast<std::uint32_t>(i))) + unit_of(bits[2]));
        const glm::dvec3 point =
            position + model.radius * reach * reach * frame.direction(share, turn);
        hidden += is_hidden(seen, model.radius, position, frame.normal, point) ? 1 : 0;
    }
    return std::max(1 - model.strength * hidden / model.samples, 0.0);
}

Cells occlusion_of_cells(const SeenSurfaces& seen, const OcclusionModel& model) {
    Cells out(seen, model.cell);
    const int side = model.cell;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            if (seen.shows(side * x, side * y)) {
                out.at(x, y) = occlusion_at(seen, model, side * x, side * y,
                                            pcg3d({static_cast<std::uint32_t>(x & 3),
                                                   static_cast<std::uint32_t>(y & 3), 0}));
            }
        }
    }
    return out;
}

Cells blurred(const SeenSurfaces& seen, const OcclusionModel& model, Cells from, bool is_along_x) {
    Cells out = from;
    const int side = model.cell;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            if (!seen.shows(side * x, side * y)) {
                continue;
            }
            double sum = 0, total = 0;
            for (int i = -2; i <= 2; ++i) {
                const int to_x = x + (is_along_x ? i : 0), to_y = y + (is_along_x ? 0 : i);
                if (to_x < 0 || to_y < 0 || to_x >= out.width || to_y >= out.height) {
                    continue;
                }
                const double weight =
                    (std::abs(i) == 2 ? 0.5 : 1) *
                    shares_plane(seen, model, side * x, side * y, side * to_x, side * to_y);
                sum += weight * from.at(to_x, to_y);
                total += weight;
            }
            out.at(x, y) = sum / total;
        }
    }
    return out;
}

} // namespace

std::vector<double> occlusion(const SeenSurfaces& seen, const OcclusionModel& model) {
    Cells cells = occlusion_of_cells(seen, model);
    for (const bool is_along_x : {true, false}) {
        cells = blurred(seen, model, std::move(cells), is_along_x);
    }
    const int side = model.cell;
    std::vector<double> out(seen.depth.size(), 1);
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x) {
            if (!seen.shows(x, y)) {
                continue;
            }
            double sum = 0, total = 0;
            for (int cell_y = y / side; cell_y <= (y + side - 1) / side; ++cell_y) {
                for (int cell_x = x / side; cell_x <= (x + side - 1) / side; ++cell_x) {
                    const int to_x = std::min(cell_x, cells.width - 1);
                    const int to_y = std::min(cell_y, cells.height - 1);
                    // A straight line between the cells, bent by who shares the plane.
                    const double near =
                        (1 - std::abs(x - side * cell_x) / static_cast<double>(side)) *
                        (1 - std::abs(y - side * cell_y) / static_cast<double>(side));
                    const double weight =
                        near * (1e-4 + shares_plane(seen, model, x, y, side * to_x, side * to_y));
                    sum += weight * cells.at(to_x, to_y);
                    total += weight;
                }
            }
            out[seen.index(x, y)] = sum / total;
        }
    }
    return out;
}

std::vector<double> occlusion_of_every_pixel(const SeenSurfaces& seen,
                                             const OcclusionModel& model) {
    constexpr std::array<std::uint32_t, 3> middle{0x80000000U, 0x80000000U, 0x80000000U};
    std::vector<double> out(seen.depth.size(), 1);
    tbb::parallel_for(0, seen.height, [&](int y) {
        for (int x = 0; x < seen.width; ++x) {
            if (seen.shows(x, y)) {
                out[seen.index(x, y)] = occlusion_at(seen, model, x, y, middle);
            }
        }
    });
    return out;
}

double
ray_cast_occlusion(glm::dvec3 normal, double radius, int rays,
                   const std::function<std::optional<double>(const glm::dvec3& direction)>& hit) {
    const Frame frame = frame_about(normal);
    double hidden = 0;
    for (int i = 0; i < rays; ++i) {
        const auto distance = hit(frame.direction((i + 0.5) / rays, fraction((i + 0.5) * golden)));
        if (distance && *distance < radius) {
            hidden += 1 - std::sqrt(*distance / radius);
        }
    }
    return 1 - hidden / rays;
}

} // namespace preview::reference
