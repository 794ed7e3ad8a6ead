#include "lutlib/half.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lutlib {
namespace {

constexpr int mantissa_bits = 10, least_exponent = -14, bias = 15;
constexpr std::uint16_t sign_bit = 0x8000, mantissa_mask = 0x3FF, exponent_mask = 0x1F;

} // namespace

std::uint16_t half_from(double value) {
    const double held = std::isnan(value) ? 0 : std::clamp(value, -largest_half, largest_half);
    const double magnitude = std::abs(held);
    const int exponent =
        std::max(magnitude > 0 ? std::ilogb(magnitude) : least_exponent, least_exponent);
    const auto mantissa =
        static_cast<int>(std::nearbyint(std::ldexp(magnitude, mantissa_bits - exponent)));
    // A mantissa of 1024 stands for the 1 before the point and one that rounds up to 2048 for 2:
    // both carry into the exponent, as they should.
    const int bits = ((exponent - least_exponent) << mantissa_bits) + mantissa;
    return static_cast<std::uint16_t>((std::signbit(held) ? sign_bit : 0) | bits);
}

float float_from_half(std::uint16_t half) {
    const int exponent = half >> mantissa_bits & exponent_mask;
    const int mantissa = half & mantissa_mask;
    float magnitude = 0;
    if (exponent == exponent_mask) {
        magnitude = mantissa ? std::numeric_limits<float>::quiet_NaN()
                             : std::numeric_limits<float>::infinity();
    } else if (exponent == 0) {
        magnitude = std::ldexp(static_cast<float>(mantissa), least_exponent - mantissa_bits);
    } else {
        magnitude = std::ldexp(static_cast<float>(mantissa + (1 << mantissa_bits)),
                               exponent - bias - mantissa_bits);
    }
    return half & sign_bit ? -magnitude : magnitude;
}

} // namespace lutlib
