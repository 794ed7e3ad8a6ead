#include "preview/reference/surroundings.h"

#include "preview/reference/ggx.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

using lutlib::RgbD;

namespace {

constexpr double pi = std::numbers::pi;

template <class Weight>
RgbD sum_over(const Image& all, Weight weight, double& weights) {
    RgbD sum{};
    weights = 0;
    for (int y = 0; y < all.height; ++y) {
        const double texel = sphere_texel(all, y);
        for (int x = 0; x < all.width; ++x) {
            const double w =
                texel * weight(sphere_direction((x + 0.5) / all.width, (y + 0.5) / all.height));
            sum = sum + all.at(x, y) * w;
            weights += w;
        }
    }
    return sum;
}

/// Constants by their definition, where the shader has their values.
double harmonic(int which, glm::dvec3 d) {
    const double one = std::sqrt(3 / (4 * pi));
    const double two = std::sqrt(15 / (4 * pi));
    switch (which) {
    case 0:
        return std::sqrt(1 / (4 * pi));
    case 1:
        return one * d.y;
    case 2:
        return one * d.z;
    case 3:
        return one * d.x;
    case 4:
        return two * d.x * d.y;
    case 5:
        return two * d.y * d.z;
    case 6:
        return std::sqrt(5 / (16 * pi)) * (3 * d.z * d.z - 1);
    case 7:
        return two * d.x * d.z;
    default:
        return two / 2 * (d.x * d.x - d.y * d.y);
    }
}

} // namespace

glm::dvec3 sphere_direction(double u, double v) {
    const double turn = (u - 0.5) * 2 * pi;
    return {std::sin(v * pi) * std::sin(turn), std::cos(v * pi),
            -std::sin(v * pi) * std::cos(turn)};
}

double sphere_texel(const Image& all, int y) {
    return 2 * pi / all.width *
           (std::cos(pi * y / all.height) - std::cos(pi * (y + 1) / all.height));
}

RgbD mirrored(const Image& all, glm::dvec3 axis, double roughness) {
    const double alpha = roughness * roughness;
    double weights = 0;
    const RgbD sum = sum_over(
        all,
        [&](glm::dvec3 direction) {
            const double cosine = glm::dot(axis, direction);
            if (cosine <= 0) {
                return 0.0;
            }
            return cosine *
                   ggx_distribution(glm::dot(axis, glm::normalize(axis + direction)), alpha);
        },
        weights);
    return sum * (1 / weights);
}

RgbD irradiance(const Image& all, glm::dvec3 normal) {
    double weights = 0;
    return sum_over(
        all, [&](glm::dvec3 direction) { return std::max(glm::dot(normal, direction), 0.0); },
        weights);
}

std::array<RgbD, 9> irradiance_harmonics(const Image& all) {
    std::array<RgbD, 9> out{};
    for (int which = 0; which < 9; ++which) {
        double weights = 0;
        out[static_cast<std::size_t>(which)] =
            sum_over(
                all, [&](glm::dvec3 direction) { return harmonic(which, direction); }, weights) *
            (which == 0  ? pi
             : which < 4 ? 2 * pi / 3
                         : pi / 4);
    }
    return out;
}

RgbD irradiance(const std::array<RgbD, 9>& harmonics, glm::dvec3 normal) {
    RgbD sum{};
    for (int which = 0; which < 9; ++which) {
        sum = sum + harmonics[static_cast<std::size_t>(which)] * harmonic(which, normal);
    }
    return sum;
}

Reflectance reflectance(double roughness, double n_dot_v, int steps) {
    const double alpha = std::pow(std::max(roughness, least_roughness), 2);
    const glm::dvec3 view(std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v);
    Reflectance out;
    // Halfway vectors in equal shares of the distribution's n.h (Walter et al. 2007).
    for (int i = 0; i < steps; ++i) {
        const double share = (i + 0.5) / steps;
        const double squared = (1 - share) / (1 + (alpha * alpha - 1) * share);
        for (int k = 0; k < steps; ++k) {
            const double turn = pi * (k + 0.5) / steps; // the other half is the same
            const double across = std::sqrt(1 - squared);
            const glm::dvec3 half(across * std::cos(turn), across * std::sin(turn),
                                  std::sqrt(squared));
            const double v_dot_h = glm::dot(view, half);
            const double n_dot_l = 2 * v_dot_h * half.z - n_dot_v;
            if (v_dot_h <= 0 || n_dot_l <= 0) {
                continue;
            }
            const double weight = 4 * smith_visibility(n_dot_l, n_dot_v, alpha) * n_dot_l *
                                  v_dot_h / half.z / (steps * steps);
            const double fresnel = std::pow(1 - v_dot_h, 5);
            out.scale += weight * (1 - fresnel);
            out.bias += weight * fresnel;
        }
    }
    return out;
}

} // namespace preview::reference
