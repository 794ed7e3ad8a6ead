#include "preview/scene/environment.h"

#include "preview/scene/angles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace preview {

namespace {

constexpr float cosine_sharpness = 2.133F, cosine_amplitude = 1.170F;

// Share of the zenith in the irradiance of a surface whose normal has the height y, for the
// gradient below at roughness 0; a fit, within 0.03 of the integral.
float zenith_share(float y) {
    const float h = std::clamp(0.5F + 0.5F * y, 0.0F, 1.0F);
    return 0.9F * h * (0.6F + 0.4F * h);
}

} // namespace

bool Environment::is_black() const {
    const glm::vec3 none{0};
    bool black = zenith == none && horizon == none && ground == none;
    for (int i = 0; i < soft_box_count; ++i) {
        black = black && soft_boxes[i].radiance == none;
    }
    return black;
}

glm::vec3 radiance(const Environment& environment, glm::vec3 direction, float roughness) {
    const float y = direction.y;
    const float width = 0.25F + 0.75F * roughness;
    const float share = std::abs(y) / std::sqrt(y * y + width * width);
    glm::vec3 sum =
        glm::mix(environment.horizon, y > 0 ? environment.zenith : environment.ground, share);
    const float alpha = std::max(roughness * roughness, 0.002F);
    const float blur = 1 / (2 * alpha * alpha);
    for (int i = 0; i < environment.soft_box_count; ++i) {
        const SoftBox& box = environment.soft_boxes[i];
        const float sharpness = box.sharpness * blur / (box.sharpness + blur);
        sum += box.radiance * (sharpness / box.sharpness *
                               std::exp(sharpness * (glm::dot(direction, box.axis) - 1)));
    }
    return sum;
}

glm::vec3 irradiance(const Environment& environment, glm::vec3 normal) {
    const float up = zenith_share(normal.y), down = zenith_share(-normal.y);
    glm::vec3 sum = pi * (up * environment.zenith + down * environment.ground +
                          (1 - up - down) * environment.horizon);
    for (int i = 0; i < environment.soft_box_count; ++i) {
        const SoftBox& box = environment.soft_boxes[i];
        const float total = box.sharpness + cosine_sharpness;
        const float length = glm::length(box.sharpness * box.axis + cosine_sharpness * normal);
        const float integral = (std::exp(length - total) - std::exp(-length - total)) / length;
        sum += box.radiance * (2 * pi * cosine_amplitude * integral);
    }
    return sum;
}

} // namespace preview
