#include "preview/reference/ggx.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

using lutlib::RgbD;

double filtered_roughness(double roughness, glm::dvec3 dx, glm::dvec3 dy) {
    const double variance = (glm::dot(dx, dx) + glm::dot(dy, dy)) / (2 * std::numbers::pi);
    const double alpha = roughness * roughness;
    return std::sqrt(std::sqrt(std::min(alpha * alpha + std::min(2 * variance, 0.18), 1.0)));
}

double ggx_distribution(double n_dot_h, double alpha) {
    const double a2 = alpha * alpha;
    const double d = n_dot_h * n_dot_h * (a2 - 1) + 1;
    return a2 / (std::numbers::pi * d * d);
}

double smith_visibility(double n_dot_l, double n_dot_v, double alpha) {
    const double a2 = alpha * alpha;
    const double l = n_dot_v * std::sqrt(n_dot_l * n_dot_l * (1 - a2) + a2);
    const double v = n_dot_l * std::sqrt(n_dot_v * n_dot_v * (1 - a2) + a2);
    return 0.5 / std::max(l + v, 1e-9);
}

Lobes lobes(const Surface& surface, glm::dvec3 view, glm::dvec3 light) {
    const double n_dot_l = std::max(glm::dot(surface.normal, light), 0.0);
    const double n_dot_v = std::max(glm::dot(surface.normal, view), 1e-4);
    const glm::dvec3 sum = view + light;
    const double length = glm::length(sum);
    const glm::dvec3 half = length > 1e-9 ? sum / length : surface.normal;
    const double n_dot_h = std::clamp(glm::dot(surface.normal, half), 0.0, 1.0);
    const double v_dot_h = std::clamp(glm::dot(view, half), 0.0, 1.0);
    const double roughness = std::max(surface.roughness, least_roughness);
    const double alpha = roughness * roughness;
    const double lobe =
        ggx_distribution(n_dot_h, alpha) * smith_visibility(n_dot_l, n_dot_v, alpha);
    const double grazing = std::pow(1 - v_dot_h, 5);
    Lobes out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double f0 = std::lerp(0.04, surface.albedo[c], surface.metalness);
        const double fresnel = f0 + (1 - f0) * grazing;
        out.diffuse[c] =
            (1 - fresnel) * (1 - surface.metalness) * surface.albedo[c] / std::numbers::pi;
        out.specular[c] = fresnel * lobe;
    }
    return out;
}

RgbD shade(const Surface& surface, glm::dvec3 view, glm::dvec3 light) {
    const double n_dot_l = glm::dot(surface.normal, light);
    if (!(n_dot_l > 0)) {
        return {};
    }
    const Lobes both = lobes(surface, view, light);
    return (both.diffuse + both.specular) * n_dot_l;
}

} // namespace preview::reference
