// The clear sky and its sun, by the place of the sun and the turbidity of the air.
//
// Preetham, Shirley and Smits 1999, "A practical analytic model for daylight": the sky's luminance
// and chromaticity (appendix A.2) and what the air leaves of the sun (appendix A.1: Rayleigh's and
// Angstrom's extinction over Kasten's optical mass; ozone and gases are left out). The model is
// negative or breaks down outside its range, so it is held inside:
// - turbidity within 2..10 (its denominators cross zero at 1.643; at 12 it is negative at sunset);
// - the sun no lower than the horizon; directions no lower than 0.6 degrees above it;
// - luminance and each primary no lower than 0.
// Below the horizon the sky keeps the colours of sunset and fades by the square root of the
// measured fall of illuminance (400 lx at sunset, 3.4 lx at -6 degrees, .002 lx at -18): the whole
// of it is more than half floats hold.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace preview {

struct Sky {
    float sun_height = 35;    ///< of the sun's middle above the horizon, degrees
    float sun_azimuth = -130; ///< as a camera's: 0 is towards -z, growing to the right
    float turbidity = 3;      ///< 2 is clear, 10 hazy
    friend bool operator==(const Sky&, const Sky&) = default;
};

/// Radiance units of the scene for a kcd/m2, and for a klx of the sun: under 100 klx diffuse white
/// is 1.
inline constexpr double units_per_kilocandela = 3.14159265358979 / 100;

/// The sun's angular radius seen from the Earth, degrees.
inline constexpr double sun_radius = 0.2665;

/// What surfaces beyond the horizon reflect of what falls on them.
inline constexpr double ground_albedo = 0.2;

/// A sky as its formulas take it; float, for the shader is given these numbers.
struct SkyBlock {
    /// By row A..E of the distribution F = (1 + A e^(B / cos t)) (1 + C e^(D g) + E cos^2 g); of
    /// Y, x and y.
    glm::vec4 distribution[5]{};
    /// Y (radiance units), x and y at the zenith, each over its F there.
    glm::vec4 zenith{0};
    glm::vec4 towards_sun{0, 1, 0, 0}; ///< unit; not below the horizon
    glm::vec4 ground{0};               ///< radiance
};

/// Unit direction to the sun's middle, also below the horizon.
glm::dvec3 towards_sun(const Sky& sky);

SkyBlock sky_block(const Sky& sky);

/// Radiance from unit `direction`, linear sRGB, without the sun itself. The CPU twin of
/// shaders/common/sky.glsl.
glm::dvec3 sky_radiance(const SkyBlock& block, glm::dvec3 direction);

/// Irradiance of the sun at normal incidence: 0 once all of it is below the horizon.
glm::dvec3 sun_irradiance(const Sky& sky);

/// Radiance of the sun's disc, its largest component held below `most`.
glm::dvec3 sun_disc(const Sky& sky, double most);

} // namespace preview
