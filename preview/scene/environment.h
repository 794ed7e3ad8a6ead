// The light that surrounds a scene: a vertical gradient and a few soft boxes, each a spherical
// Gaussian, so that its blur by a rough surface and its irradiance have closed forms.
// shaders/common/environment.glsl is the same in GLSL.
//
// A spherical Gaussian of axis m, sharpness s and amplitude a has the radiance a e^(s (d.m - 1))
// in direction d. Wang et al. 2009, "All-frequency rendering of dynamic, spatially-varying
// reflectance"; the cosine as a Gaussian of sharpness 2.133 and amplitude 1.170 from Meder and
// Bruederlin 2018, "Hemispherical Gaussians for accurate light integration".
#pragma once

#include <glm/vec3.hpp>

namespace preview {

struct SoftBox {
    glm::vec3 axis{0, 1, 0}; ///< unit
    float sharpness = 20;
    glm::vec3 radiance{0};
};

struct Environment {
    static constexpr int max_soft_boxes = 4;

    glm::vec3 zenith{0}, horizon{0}, ground{0};
    SoftBox soft_boxes[max_soft_boxes];
    int soft_box_count = 0;

    bool is_black() const;
};

/// Radiance from unit `direction` averaged over a GGX lobe of perceptual `roughness` about it.
glm::vec3 radiance(const Environment& environment, glm::vec3 direction, float roughness);

/// Irradiance of a surface with unit `normal`.
glm::vec3 irradiance(const Environment& environment, glm::vec3 normal);

} // namespace preview
