#include "preview/reference/gradient.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

using lutlib::RgbD;

namespace {

RgbD rgb_of(glm::vec3 v) {
    return lutlib::to_double(lutlib::Rgb{v.x, v.y, v.z});
}

/// e^(sharpness (d.axis - 1)), `amplitude` times.
struct Gaussian {
    glm::dvec3 axis;
    double sharpness, amplitude = 1;

    double at(glm::dvec3 direction) const {
        return amplitude * std::exp(sharpness * (glm::dot(direction, axis) - 1));
    }
    /// Over all directions.
    double integral() const {
        return amplitude * 2 * std::numbers::pi / sharpness * -std::expm1(-2 * sharpness);
    }
    friend Gaussian operator*(const Gaussian& a, const Gaussian& b) {
        const glm::dvec3 sum = a.sharpness * a.axis + b.sharpness * b.axis;
        const double sharpness = glm::length(sum);
        return {sum / sharpness, sharpness,
                a.amplitude * b.amplitude * std::exp(sharpness - a.sharpness - b.sharpness)};
    }
};

Gaussian gaussian_of(const SoftBox& box) {
    return {glm::dvec3(box.axis), static_cast<double>(box.sharpness)};
}

/// As sharp as the lobe of a rough surface leaves it, and with the light that it had.
Gaussian blurred(const Gaussian& box, double roughness) {
    const double alpha = std::max(roughness * roughness, 0.002);
    const double sharpness = 1 / (1 / box.sharpness + 2 * alpha * alpha);
    return {box.axis, sharpness, box.amplitude * sharpness / box.sharpness};
}

/// The fit of preview/scene/environment.cpp.
double zenith_share(double y) {
    const double h = std::clamp((1 + y) / 2, 0.0, 1.0);
    return 0.54 * h + 0.36 * h * h;
}

} // namespace

RgbD radiance(const Environment& environment, glm::dvec3 direction, double roughness) {
    const double share = std::abs(direction.y) / std::hypot(direction.y, 0.25 + 0.75 * roughness);
    RgbD sum = rgb_of(environment.horizon) * (1 - share) +
               rgb_of(direction.y > 0 ? environment.zenith : environment.ground) * share;
    for (int i = 0; i < environment.soft_box_count; ++i) {
        const SoftBox& box = environment.soft_boxes[i];
        sum = sum + rgb_of(box.radiance) * blurred(gaussian_of(box), roughness).at(direction);
    }
    return sum;
}

RgbD irradiance(const Environment& environment, glm::dvec3 normal) {
    const double up = zenith_share(normal.y), down = zenith_share(-normal.y);
    RgbD sum = (rgb_of(environment.zenith) * up + rgb_of(environment.ground) * down +
                rgb_of(environment.horizon) * (1 - up - down)) *
               std::numbers::pi;
    const Gaussian cosine{normal, 2.133, 1.170}; // nearly n.d
    for (int i = 0; i < environment.soft_box_count; ++i) {
        const SoftBox& box = environment.soft_boxes[i];
        sum = sum + rgb_of(box.radiance) * (gaussian_of(box) * cosine).integral();
    }
    return sum;
}

} // namespace preview::reference
