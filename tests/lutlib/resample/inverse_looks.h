// Looks that tests invert.
#pragma once

#include "tests/lutlib/looks.h"

#include <cmath>
#include <utility>

namespace lutlib {

inline Lut cube_look(Lut3D cube) {
    Lut out;
    out.cube = std::move(cube);
    return out;
}

/// Invertible: rising, channels mixed a little, within 0..1.
inline RgbD gentle(RgbD c) {
    const double y = test_luma(c);
    const auto bend = [](double x) { return x + 0.12 * std::sin(6.283185307179586 * x) / 6.28; };
    return {bend(0.85 * c.r + 0.15 * y), bend(0.85 * c.g + 0.15 * y), bend(0.85 * c.b + 0.15 * y)};
}

} // namespace lutlib
