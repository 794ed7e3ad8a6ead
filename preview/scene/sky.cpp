#include "preview/scene/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace preview {

namespace {

constexpr double least_cosine = 0.01;
constexpr double least_turbidity = 2, most_turbidity = 10;

/// A number that grows with turbidity: slope, offset.
struct Line {
    double slope, offset;
};

// Preetham, appendix A.2: A..E of Y, x and y.
constexpr std::array<std::array<Line, 5>, 3> distributions{{
    {{{0.1787, -1.4630},
      {-0.3554, 0.4275},
      {-0.0227, 5.3251},
      {0.1206, -2.5771},
      {-0.0670, 0.3703}}},
    {{{-0.0193, -0.2592},
      {-0.0665, 0.0008},
      {-0.0004, 0.2125},
      {-0.0641, -0.8989},
      {-0.0033, 0.0452}}},
    {{{-0.0167, -0.2608},
      {-0.0950, 0.0092},
      {-0.0079, 0.2102},
      {-0.0441, -1.6537},
      {-0.0109, 0.0529}}},
}};

// Chromaticity at the zenith: a row for the third to the zeroth power of the sun's angle, a column
// for the square of the turbidity, itself, and 1.
using Zenith = std::array<std::array<double, 3>, 4>;
constexpr Zenith zenith_x{{{0.00166, -0.02903, 0.11693},
                           {-0.00375, 0.06377, -0.21196},
                           {0.00209, -0.03202, 0.06052},
                           {0, 0.00394, 0.25886}}};
constexpr Zenith zenith_y{{{0.00275, -0.04214, 0.15346},
                           {-0.00610, 0.08970, -0.26756},
                           {0.00317, -0.04153, 0.06670},
                           {0, 0.00516, 0.26688}}};

double at_zenith(const Zenith& table, double turbidity, double angle) {
    double sum = 0;
    for (const auto& row : table) {
        sum = sum * angle + (row[0] * turbidity + row[1]) * turbidity + row[2];
    }
    return sum;
}

double held_turbidity(const Sky& sky) {
    return std::clamp(static_cast<double>(sky.turbidity), least_turbidity, most_turbidity);
}

/// kcd/m2.
double zenith_luminance(double turbidity, double angle) {
    const double chi = (4.0 / 9 - turbidity / 120) * (std::numbers::pi - 2 * angle);
    return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

double distribution(const SkyBlock& block, int channel, double cosine, double cos_sun) {
    const auto row = [&](int at) { return static_cast<double>(block.distribution[at][channel]); };
    const double angle = std::acos(std::clamp(cos_sun, -1.0, 1.0));
    return (1 + row(0) * std::exp(row(1) / std::max(cosine, least_cosine))) *
           (1 + row(2) * std::exp(row(3) * angle) + row(4) * cos_sun * cos_sun);
}

/// How much is left of the sky's light at sunset, once the sun is below the horizon; the square
/// root of a fall of 10^-2.07 at 6 and 10^-5.3 at 18 degrees.
double twilight(double height) {
    const double below = std::clamp(-height, 0.0, 40.0);
    return std::pow(10.0, 0.5 * below * (0.00421 * below - 0.3703));
}

/// The share of the sun's disc above the horizon, nearly: smooth over its height.
double risen_share(double height) {
    const double t = std::clamp(height / (2 * sun_radius) + 0.5, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// IEC 61966-2-1.
glm::dvec3 srgb_of_xyz(glm::dvec3 c) {
    return {3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
            0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z};
}

/// Of a level sheet under the sky, by the midpoints of 16 heights and 32 azimuths.
glm::dvec3 level_irradiance(const SkyBlock& block) {
    constexpr int heights = 16, azimuths = 32;
    glm::dvec3 sum(0);
    for (int i = 0; i < heights; ++i) {
        const double squared = (i + 0.5) / heights; // equal steps of sin^2 have equal weights
        const double up = std::sqrt(squared);
        const double across = std::sqrt(1 - squared);
        for (int k = 0; k < azimuths; ++k) {
            const double turn = 2 * std::numbers::pi * (k + 0.5) / azimuths;
            sum += sky_radiance(block, {across * std::sin(turn), up, across * std::cos(turn)});
        }
    }
    return sum * (std::numbers::pi / (heights * azimuths));
}

} // namespace

glm::dvec3 towards_sun(const Sky& sky) {
    const double height = glm::radians(static_cast<double>(sky.sun_height));
    const double azimuth = glm::radians(static_cast<double>(sky.sun_azimuth));
    return {std::cos(height) * std::sin(azimuth), std::sin(height),
            -std::cos(height) * std::cos(azimuth)};
}

SkyBlock sky_block(const Sky& sky) {
    const double turbidity = held_turbidity(sky);
    Sky held = sky;
    held.sun_height = std::clamp(sky.sun_height, 0.0F, 90.0F);
    const double angle = glm::radians(90.0 - static_cast<double>(held.sun_height));
    SkyBlock block;
    for (int channel = 0; channel < 3; ++channel) {
        for (int row = 0; row < 5; ++row) {
            const Line& line =
                distributions[static_cast<std::size_t>(channel)][static_cast<std::size_t>(row)];
            block.distribution[row][channel] =
                static_cast<float>(line.slope * turbidity + line.offset);
        }
    }
    const double luminance = std::max(zenith_luminance(turbidity, angle), 0.0) *
                             units_per_kilocandela * twilight(static_cast<double>(sky.sun_height));
    const glm::dvec3 zenith(luminance, at_zenith(zenith_x, turbidity, angle),
                            at_zenith(zenith_y, turbidity, angle));
    for (int channel = 0; channel < 3; ++channel) {
        block.zenith[channel] =
            static_cast<float>(zenith[channel] / distribution(block, channel, 1, std::cos(angle)));
    }
    block.towards_sun = glm::vec4(glm::vec3(towards_sun(held)), 0);
    const glm::dvec3 irradiance =
        level_irradiance(block) +
        sun_irradiance(sky) *
            std::max(std::sin(glm::radians(static_cast<double>(sky.sun_height))), 0.0);
    block.ground = glm::vec4(glm::vec3(irradiance * (ground_albedo / std::numbers::pi)), 0);
    return block;
}

glm::dvec3 sky_radiance(const SkyBlock& block, glm::dvec3 direction) {
    const double cos_sun =
        std::clamp(glm::dot(direction, glm::dvec3(block.towards_sun)), -1.0, 1.0);
    glm::dvec3 value;
    for (int channel = 0; channel < 3; ++channel) {
        value[channel] = static_cast<double>(block.zenith[channel]) *
                         distribution(block, channel, direction.y, cos_sun);
    }
    const double luminance = std::max(value.x, 0.0), y = std::max(value.z, 0.01);
    const glm::dvec3 xyz(luminance * value.y / y, luminance,
                         luminance * (1 - value.y - value.z) / y);
    const glm::dvec3 above = glm::max(srgb_of_xyz(xyz), 0.0);
    // The horizon is as sharp as a pixel of a wide view.
    return glm::mix(glm::dvec3(block.ground), above, glm::smoothstep(-0.002, 0.002, direction.y));
}

glm::dvec3 sun_irradiance(const Sky& sky) {
    constexpr double klx_outside = 128; // of the sun, above the air
    // The wavelengths of the primaries, micrometres.
    const glm::dvec3 wavelength(0.610, 0.550, 0.465);
    const double height = std::clamp(static_cast<double>(sky.sun_height), 0.0, 90.0);
    const double mass = 1 / (std::sin(glm::radians(height)) +
                             0.15 * std::pow(93.885 - (90 - height), -1.253)); // Kasten 1965
    const double beta = 0.04608 * held_turbidity(sky) - 0.04586;
    glm::dvec3 left;
    for (int c = 0; c < 3; ++c) {
        left[c] = std::exp(-mass * (0.008735 * std::pow(wavelength[c], -4.08) +
                                    beta * std::pow(wavelength[c], -1.3)));
    }
    return left *
           (klx_outside * units_per_kilocandela * risen_share(static_cast<double>(sky.sun_height)));
}

glm::dvec3 sun_disc(const Sky& sky, double most) {
    const double sine = std::sin(glm::radians(sun_radius));
    const glm::dvec3 radiance = sun_irradiance(sky) / (std::numbers::pi * sine * sine);
    const double largest = std::max({radiance.x, radiance.y, radiance.z, most});
    return radiance * (most / largest);
}

} // namespace preview
