#include "preview/reference/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace preview::reference {

namespace {

std::uint32_t hash(std::array<int, 3> cell) {
    const auto start = [&](std::size_t axis) {
        return static_cast<std::uint32_t>(cell[axis] & 255) * 1664525U + 1013904223U;
    };
    std::uint32_t x = start(0);
    std::uint32_t y = start(1);
    std::uint32_t z = start(2);
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16U;
    y ^= y >> 16U;
    z ^= z >> 16U;
    return x + y * z;
}

double slope(std::array<int, 3> cell, glm::dvec3 from) {
    const std::uint32_t h = hash(cell) >> 28U;
    const double u = h < 8 ? from.x : from.y;
    const double v = h < 4 ? from.y : h == 12 || h == 14 ? from.x : from.z;
    return ((h & 1U) != 0 ? -u : u) + ((h & 2U) != 0 ? -v : v);
}

double weight(double f) {
    return f * f * f * (f * (f * 6 - 15) + 10);
}

double decoded(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

} // namespace

double perlin(glm::dvec3 p) {
    const glm::dvec3 low(std::floor(p.x), std::floor(p.y), std::floor(p.z));
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const std::array<int, 3> corner{i & 1, i >> 1 & 1, i >> 2};
        std::array<int, 3> cell{};
        glm::dvec3 from;
        double share = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            cell[at] = static_cast<int>(low[axis]) + corner[at];
            from[axis] = p[axis] - low[axis] - corner[at];
            const double w = weight(p[axis] - low[axis]);
            share *= corner[at] != 0 ? w : 1 - w;
        }
        sum += share * slope(cell, from);
    }
    return sum;
}

lutlib::RgbD noise_background(glm::dvec4 noise, glm::dvec3 direction) {
    glm::dvec3 p = direction * noise.z + glm::dvec3(0, 0, noise.w);
    double sum = 0;
    for (double strength = 0.5; strength > 0.03; strength /= 2, p *= 2.0) {
        sum += strength * perlin(p);
    }
    const double saturation = std::clamp(0.5 + 1.5 * sum, 0.0, 1.0);
    lutlib::RgbD out;
    const std::array<double, 3> turns{5, 3, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        const double k = std::fmod(turns[c] + noise.x * 6, 6.0);
        out[c] = decoded(noise.y * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0)));
    }
    return out;
}

} // namespace preview::reference
