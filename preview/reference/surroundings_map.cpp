#include "preview/reference/surroundings_map.h"

#include "preview/reference/surroundings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

using glm::dvec3;
using lutlib::RgbD;

namespace {

/// Two weights of 8 bits.
constexpr double unit_rounding = 2.0 / 512;

/// Bilinear about a place in texels, whose columns `column` chooses.
template <class Column>
Filtered bilinear(const Image& image, double x, double y, Column column) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    Filtered out;
    RgbD least{HUGE_VAL, HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 4; ++i) {
        const int dx = i % 2, dy = i / 2;
        const double weight_x = x - 0.5 - left, weight_y = y - 0.5 - top;
        const RgbD& texel = image.at(column(static_cast<int>(left) + dx),
                                     std::clamp(static_cast<int>(top) + dy, 0, image.height - 1));
        out.light = out.light + texel * ((dx == 1 ? weight_x : 1 - weight_x) *
                                         (dy == 1 ? weight_y : 1 - weight_y));
        for (std::size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], texel[c]);
            most[c] = std::max(most[c], texel[c]);
        }
    }
    out.doubt = (most - least) * unit_rounding;
    return out;
}

Filtered mixed(const Filtered& a, const Filtered& b, double share) {
    return {a.light * (1 - share) + b.light * share, a.doubt * (1 - share) + b.doubt * share};
}

/// Of a lobe of that roughness about a turned direction.
Filtered mirrored_by(const SurroundingsMaps& maps, dvec3 direction, double roughness) {
    const int count = maps.level_count, height = maps.levels.height / count;
    // Level 0 is that of the roughness 1 / count, and a mirror stands in front of it.
    const double level = std::clamp(roughness, 0.0, 1.0) * count - 1;
    const auto of_level = [&](int which) {
        return sphere_sample(maps.levels, direction, std::min(which, count - 1), height);
    };
    if (level < 0) {
        return mixed(of_level(0), maps.mirror(direction), -level);
    }
    const int lower = static_cast<int>(level);
    return mixed(of_level(lower), of_level(lower + 1), level - lower);
}

} // namespace

dvec3 turned(const SurroundingsMaps& maps, dvec3 direction) {
    const double c = std::cos(maps.turn), s = std::sin(maps.turn);
    return {c * direction.x + s * direction.z, direction.y, c * direction.z - s * direction.x};
}

Filtered sphere_sample(const Image& all, dvec3 direction, int level, int height) {
    const double turn =
        std::hypot(direction.x, direction.z) > 1e-7 ? std::atan2(direction.x, -direction.z) : 0;
    const double x = (turn / (2 * std::numbers::pi) + 0.5) * all.width;
    const double down =
        std::atan2(std::hypot(direction.x, direction.z), direction.y) / std::numbers::pi;
    const double y = std::clamp(down * height, 0.5, height - 0.5) + level * height;
    return bilinear(all, x, y, [&](int column) { return (column + all.width) % all.width; });
}

Filtered reflected(const SurroundingsMaps& maps, const Surface& surface, dvec3 view, double seen,
                   double seen_mirrored) {
    const Image& table = maps.reflectance;
    const double n_dot_v = glm::dot(surface.normal, view);
    // Nodes stand at both ends.
    const auto place = [](double share, int nodes) {
        return std::clamp(share, 0.0, 1.0) * (nodes - 1) + 0.5;
    };
    const Filtered part =
        bilinear(table, place(n_dot_v, table.width), place(surface.roughness, table.height),
                 [&](int column) { return std::clamp(column, 0, table.width - 1); });
    const double scale = part.light.r, bias = part.light.g;
    const double missing = std::clamp(1 - scale - bias, 0.0, 1.0);
    const Filtered mirrored =
        mirrored_by(maps, turned(maps, 2 * n_dot_v * surface.normal - view), surface.roughness);
    const RgbD around = irradiance(maps.harmonics, turned(maps, surface.normal));
    Filtered out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double albedo = surface.albedo[c];
        const double f0 = std::lerp(0.04, albedo, surface.metalness);
        const double once = f0 * scale + bias;
        const double mean = f0 + (1 - f0) / 21; // of Schlick's Fresnel over all directions
        const double more = missing * once * mean / (1 - mean * missing);
        const double diffuse = (1 - once - more) * (1 - surface.metalness) * albedo;
        const double of_mirrored = seen_mirrored * once * maps.factor;
        const double of_around = seen / std::numbers::pi * std::max(around[c], 0.0) * maps.factor;
        out.light[c] = of_mirrored * mirrored.light[c] + of_around * (more + diffuse);
        const double moved = part.doubt.r * f0 + part.doubt.g;
        out.doubt[c] = of_mirrored * mirrored.doubt[c] +
                       moved * (seen_mirrored * maps.factor * mirrored.light[c] + of_around);
    }
    return out;
}

} // namespace preview::reference
