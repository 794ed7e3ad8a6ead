#include "lutlib/half.h"

#include <algorithm>
#include <bit>
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

std::uint16_t half_near(float value) {
    // Of a float's bits: its sign, infinity, 65520 (which would round up to one), 2^-14 and .5.
    constexpr std::uint32_t sign = 0x80000000, infinity = 0x7F800000, too_large = 0x477FF000,
                            least_normal = 0x38800000, half_bits = 0x3F000000, lost_bits = 13;
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t magnitude = bits & ~sign;
    std::uint32_t out = 0;
    if (magnitude >= infinity) {
        out = magnitude > infinity ? 0x7E00 : 0x7C00;
    } else if (magnitude >= too_large) {
        out = 0x7BFF;
    } else if (magnitude < least_normal) {
        // The sum's last bit is the least half's: the addition rounds.
        out = std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5F) - half_bits;
    } else {
        const std::uint32_t is_odd = magnitude >> lost_bits & 1;
        out = (magnitude - ((127U - 15U) << 23U) + 0xFFF + is_odd) >> lost_bits;
    }
    return static_cast<std::uint16_t>(out | (bits & sign) >> 16U);
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
