// What surfaces take of surroundings, in double and by plain sums over a picture of all directions:
// twins of shaders/surroundings_levels.comp and surroundings_harmonics.comp, and of the
// reflectance that shaders/common/surroundings.glsl has a formula for.
#pragma once

#include "preview/reference/image.h"

#include <glm/vec3.hpp>

#include <array>

namespace preview::reference {

/// The direction of a place in a picture of all directions: u turns to the right with -z in the
/// middle, v goes down from +y; both 0..1.
glm::dvec3 sphere_direction(double u, double v);
/// The solid angle of a texel in row `y`.
double sphere_texel(const Image& all, int y);

/// The mean under the GGX lobe of perceptual `roughness` that is seen along its axis.
lutlib::RgbD mirrored(const Image& all, glm::dvec3 axis, double roughness);

/// Irradiance of a surface with that normal, by the cosine.
lutlib::RgbD irradiance(const Image& all, glm::dvec3 normal);

/// The same by spherical harmonics up to order 2, whose coefficients, times the cosine's lobe, are
/// these.
std::array<lutlib::RgbD, 9> irradiance_harmonics(const Image& all);
lutlib::RgbD irradiance(const std::array<lutlib::RgbD, 9>& harmonics, glm::dvec3 normal);

/// What GGX with height-correlated masking reflects of a white sphere of directions, of a Fresnel
/// reflectance f0 + (1 - f0) (1 - v.h)^5: scale and bias of f0. By midpoints.
struct Reflectance {
    double scale = 0, bias = 0;
};
Reflectance reflectance(double roughness, double n_dot_v, int steps = 128);

} // namespace preview::reference
