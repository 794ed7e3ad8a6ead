#include "preview/reference/shadow_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace preview::reference {

using glm::dvec2;
using glm::dvec3;

namespace {

/// The shader's.
constexpr std::array<std::array<double, 2>, 8> disc{{{-1.806, 1.313},
                                                     {2.337, 0.248},
                                                     {0.067, -0.783},
                                                     {-1.781, -0.392},
                                                     {1.799, -1.499},
                                                     {-0.298, 2.377},
                                                     {-0.938, -2.209},
                                                     {0.62, 0.945}}};

/// Surfaces that a light grazes are compared as if it met them at this sine.
constexpr double least_sine = 0.05;

bool is_sun(const LightBlock& light) {
    return light.range.w > 0;
}

/// A map that a light looks at, and how.
struct Map {
    dvec3 forward, right, up;
    double tangent, near_plane, far_plane;
    bool is_parallel;
    int layer;

    double depth_of(double z) const {
        const double range = far_plane - near_plane;
        return is_parallel ? (z - near_plane) / range : far_plane / range * (1 - near_plane / z);
    }
};

Map map_of(const LightBlock& light) {
    return {dvec3(light.forward),
            dvec3(light.right_tangent),
            dvec3(light.up_thickness),
            static_cast<double>(light.right_tangent.w),
            static_cast<double>(light.range.y),
            static_cast<double>(light.range.z),
            is_sun(light),
            static_cast<int>(light.position_layer.w)};
}

/// Of six that in whose direction `from` points: +x, -x, +y and so on. False: it has no casters.
bool turn_to_face(Map& map, std::uint32_t faces, dvec3 from) {
    int axis = 0;
    for (const int other : {1, 2}) {
        axis = std::abs(from[other]) > std::abs(from[axis]) ? other : axis;
    }
    const int face = 2 * axis + (from[axis] < 0 ? 1 : 0);
    map.forward = map.right = map.up = dvec3(0);
    map.forward[axis] = from[axis] < 0 ? -1 : 1;
    map.right[(axis + 1) % 3] = 1;
    map.up[(axis + 2) % 3] = 1;
    map.layer += face;
    return (faces >> static_cast<unsigned>(face) & 1U) != 0;
}

/// The surface's plane through `from`, seen in a map.
struct Plane {
    const Map& map;
    dvec3 from, normal;

    /// `beside`: on the screen of the map, whose half side is 1, from where `from` is.
    double depth_at(dvec2 beside) const {
        const double z = glm::dot(from, map.forward);
        const double moved = map.tangent * (beside.x * glm::dot(normal, map.right) +
                                            beside.y * glm::dot(normal, map.up));
        if (map.is_parallel) {
            // n.p is the same everywhere. Shadows go on behind the casters' box, which holds 1.
            return z >= map.far_plane
                       ? 1
                       : map.depth_of(z -
                                      moved / std::min(glm::dot(normal, map.forward), -least_sine));
        }
        // A ray z (forward + x right + y up) meets the plane where 1 / z = n.ray / n.from.
        const double height = std::min(glm::dot(normal, from), -least_sine * glm::length(from));
        return map.depth_of(1 / (1 / z + moved / height));
    }
};

/// How much of a texel's side lies within the filter's.
double overlap(double texel, double middle, double side) {
    return std::max(
        std::min(texel + 0.5, middle + side / 2) - std::max(texel - 0.5, middle - side / 2), 0.0);
}

/// A square of side by side texels about `middle`, where `origin` is the plane's own place.
Arrival arrival_about(const ShadowMaps& maps, const Plane& plane, dvec2 middle, dvec2 origin,
                      double side) {
    // Of depths 0..1 in floats, and of the places that they belong to.
    constexpr double rounding = 0x1p-22;
    const auto first = [&](double at) { return static_cast<int>(std::floor(at - side / 2)); };
    const auto last = [&](double at) { return static_cast<int>(std::ceil(at + side / 2)); };
    const auto held = [&](int at) {
        return static_cast<std::size_t>(std::clamp(at, 0, maps.side - 1));
    };
    const auto length = static_cast<std::size_t>(maps.side);
    const float* const layer =
        maps.depths.data() + static_cast<std::size_t>(plane.map.layer) * length * length;
    Arrival out{.share = 0};
    for (int y = first(middle.y); y <= last(middle.y); ++y) {
        for (int x = first(middle.x); x <= last(middle.x); ++x) {
            const double weight =
                overlap(x, middle.x, side) * overlap(y, middle.y, side) / (side * side);
            if (weight <= 0) {
                continue;
            }
            const dvec2 beside = (dvec2(x, y) - origin) * 2.0 / static_cast<double>(maps.side);
            const double own = plane.depth_at(beside),
                         stored = static_cast<double>(layer[held(y) * length + held(x)]);
            const double size = 1 + std::abs(own - plane.depth_at(dvec2(0))) * maps.side;
            out.share += stored >= own ? weight : 0;
            out.doubt += std::abs(stored - own) < rounding * size ? weight : 0;
        }
    }
    return out;
}

} // namespace

Arrival arrival(const ShadowMaps& maps, const LightBlock& light, const ShadowFilter& filter,
                dvec3 position, dvec3 face) {
    Map map = map_of(light);
    dvec3 from = position - dvec3(map.is_parallel ? light.extent_shape : light.position_layer);
    if (light.faces.x != 0 && !turn_to_face(map, light.faces.x, from)) {
        return {};
    }
    // Half a texel along the normal stands for the facets of round things.
    const double distance = map.is_parallel ? 1 : glm::dot(from, map.forward);
    from += face * (static_cast<double>(light.intensity_texel.w) / 2 * distance);
    const double z = glm::dot(from, map.forward);
    if (!(z > map.near_plane && (map.is_parallel || z < map.far_plane))) {
        return {};
    }
    const dvec2 screen = dvec2(glm::dot(from, map.right), glm::dot(from, map.up)) /
                         (map.is_parallel ? map.tangent : z * map.tangent);
    if (std::abs(screen.x) > 1 || std::abs(screen.y) > 1) {
        return {};
    }
    const Plane plane{map, from, face};
    const dvec2 place = (screen + 1.0) / 2.0 * static_cast<double>(maps.side) - 0.5;
    Arrival out{.share = 0};
    for (std::uint32_t i = 0; i < filter.places; ++i) {
        const dvec2 beside = filter.places > 1 ? dvec2(disc[i][0], disc[i][1]) : dvec2(0);
        const Arrival one = arrival_about(maps, plane, place + beside, place, filter.side);
        out.share += one.share / filter.places;
        out.doubt += one.doubt / filter.places;
    }
    return out;
}

} // namespace preview::reference
