// Values of 0..1 as integer codes of so many bits, and back.
#pragma once

#include "lutlib/rgb.h"

#include <cmath>
#include <cstdint>

namespace lutlib {

/// The depth of a picture's samples: codes run from 0 to 2^bits - 1, which stands for 1.
struct CodeDepth {
    int bits = 8; ///< 1..16

    constexpr int maximum() const { return (1 << bits) - 1; }

    /// The nearest code, the upper of two that are equally near. Values outside 0..1 are held to
    /// it; NaN is 0.
    std::uint16_t code(double value) const {
        return static_cast<std::uint16_t>(std::floor(saturate(value) * maximum() + 0.5));
    }
    /// The same in float arithmetic, for picture files, whose bytes it settles: of 16 bits, values
    /// that lie within 1/256 of a code's step of the middle between two may become the other.
    std::uint16_t code(float value) const {
        return static_cast<std::uint16_t>(
            std::lround(saturate(value) * static_cast<float>(maximum())));
    }
    constexpr double value(int code) const { return static_cast<double>(code) / maximum(); }
    /// What is left of a value that is kept as a code.
    double rounded(double value) const { return this->value(code(value)); }

    friend bool operator==(const CodeDepth&, const CodeDepth&) = default;
};

} // namespace lutlib
