// Twins of shaders/common/hash.glsl and of luma.glsl.
#pragma once

#include "lutlib/rgb.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace preview::reference {

using Words = std::array<std::uint32_t, 3>;

/// Jarzynski and Olano 2020, "Hash functions for GPU rendering".
inline Words pcg3d(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    Words v{x, y, z};
    const auto mix = [&v] {
        v[0] += v[1] * v[2];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
    };
    for (std::uint32_t& word : v) {
        word = word * 1664525U + 1013904223U;
    }
    mix();
    for (std::uint32_t& word : v) {
        word ^= word >> 16U;
    }
    mix();
    return v;
}

/// 0 and more, below 1.
inline double unit_of(std::uint32_t bits) {
    return (bits >> 8U) * 0x1p-24;
}

/// Within -1..1, of variance 1/6.
inline double triangular_of(std::uint32_t bits) {
    return ((bits & 0xFFFFU) + (bits >> 16U)) / 65536.0 - 1;
}

inline double luma_of(const lutlib::RgbD& codes) {
    return 0.2126 * codes.r + 0.7152 * codes.g + 0.0722 * codes.b;
}

inline lutlib::RgbD saturated(lutlib::RgbD color) {
    for (std::size_t c = 0; c < 3; ++c) {
        color[c] = std::clamp(color[c], 0.0, 1.0);
    }
    return color;
}

inline lutlib::RgbD mixed(const lutlib::RgbD& a, const lutlib::RgbD& b, double share) {
    return a * (1 - share) + b * share;
}

} // namespace preview::reference
