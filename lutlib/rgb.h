// A colour of three channels, in float for pictures and LUTs, in double for oracles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace lutlib {

template <class T>
struct BasicRgb {
    T r{}, g{}, b{};

    constexpr T& operator[](std::size_t channel) { return channel == 0 ? r : channel == 1 ? g : b; }
    constexpr const T& operator[](std::size_t channel) const {
        return channel == 0 ? r : channel == 1 ? g : b;
    }
    friend constexpr bool operator==(const BasicRgb&, const BasicRgb&) = default;

    friend constexpr BasicRgb operator+(BasicRgb a, BasicRgb c) {
        return {a.r + c.r, a.g + c.g, a.b + c.b};
    }
    friend constexpr BasicRgb operator-(BasicRgb a, BasicRgb c) {
        return {a.r - c.r, a.g - c.g, a.b - c.b};
    }
    friend constexpr BasicRgb operator*(BasicRgb a, T s) { return {a.r * s, a.g * s, a.b * s}; }
    friend constexpr BasicRgb operator*(T s, BasicRgb a) { return a * s; }
};

using Rgb = BasicRgb<float>;
using RgbD = BasicRgb<double>;

constexpr RgbD to_double(Rgb c) {
    return {c.r, c.g, c.b};
}
constexpr Rgb to_float(RgbD c) {
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

/// Clamped to 0..1; NaN becomes 0.
template <class T>
requires std::is_floating_point_v<T>
constexpr T saturate(T x) {
    return x > T{0} ? (x < T{1} ? x : T{1}) : T{0};
}
template <class T>
constexpr BasicRgb<T> saturate(BasicRgb<T> c) {
    return {saturate(c.r), saturate(c.g), saturate(c.b)};
}

/// The largest channel by absolute value; +Inf when a channel is NaN, which std::max would drop.
inline double largest_magnitude(RgbD c) {
    const double largest = std::max(std::max(std::abs(c.r), std::abs(c.g)), std::abs(c.b));
    return std::isnan(c.r + c.g + c.b) ? std::numeric_limits<double>::infinity() : largest;
}

} // namespace lutlib
