// Half floats: IEEE 754 binary16, with 5 bits of exponent and 10 of mantissa.
#pragma once

#include <cstdint>

namespace lutlib {

inline constexpr double largest_half = 65504;

/// The nearest half, of two the one whose last bit is 0. Values beyond the largest finite half are
/// held to it; NaN is 0.
std::uint16_t half_from(double value);

/// The same of a picture's sample, quickly: infinities and NaN stay what they are.
std::uint16_t half_near(float value);

/// Exactly, with infinities, NaN and signed zeros.
float float_from_half(std::uint16_t half);

} // namespace lutlib
