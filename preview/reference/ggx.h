// The surface model of the lighting pass in double: Lambert and GGX under one direction of light.
//
// Walter et al. 2007 (distribution), Heitz 2014 (height-correlated Smith masking), Schlick 1994
// (Fresnel); alpha = roughness^2, roughness at least .045 so that nothing divides by zero.
#pragma once

#include "lutlib/rgb.h"

#include <glm/vec3.hpp>

namespace preview::reference {

struct Surface {
    glm::dvec3 normal{0, 1, 0}; ///< unit
    lutlib::RgbD albedo{0.5, 0.5, 0.5};
    double roughness = 0.5, metalness = 0;
};

inline constexpr double least_roughness = 0.045;

/// The roughness of a pixel in which the unit normal changes by dx and dy to those beside:
/// Tokuyoshi and Kaplanyan 2019, "Improved geometric specular antialiasing", isotropic.
double filtered_roughness(double roughness, glm::dvec3 dx, glm::dvec3 dy);

/// The GGX distribution of normals, per steradian.
double ggx_distribution(double n_dot_h, double alpha);
/// G2 / (4 n.l n.v).
double smith_visibility(double n_dot_l, double n_dot_v, double alpha);

/// The model without n.l, from unit `light` to unit `view`.
struct Lobes {
    lutlib::RgbD diffuse, specular;
};
Lobes lobes(const Surface& surface, glm::dvec3 view, glm::dvec3 light);

/// Radiance towards unit `view` per unit of irradiance at normal incidence from unit `light`:
/// the model times n.l. Zero from behind.
lutlib::RgbD shade(const Surface& surface, glm::dvec3 view, glm::dvec3 light);

} // namespace preview::reference
