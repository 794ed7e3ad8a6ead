#include "lutlib/health/jacobian.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

double dot(RgbD a, RgbD b) {
    return a.r * b.r + a.g * b.g + a.b * b.b;
}

RgbD cross(RgbD a, RgbD b) {
    return {a.g * b.b - a.b * b.g, a.b * b.r - a.r * b.b, a.r * b.g - a.g * b.r};
}

// The largest eigenvalue of A'A, for the columns of A.
double largest_of_gram(const Jacobian& a) {
    const double rr = dot(a[0], a[0]), gg = dot(a[1], a[1]), bb = dot(a[2], a[2]);
    const double rg = dot(a[0], a[1]), gb = dot(a[1], a[2]), rb = dot(a[0], a[2]);
    const double mean = (rr + gg + bb) / 3;
    const double x = rr - mean, y = gg - mean, z = bb - mean;
    const double p = std::sqrt((x * x + y * y + z * z + 2 * (rg * rg + gb * gb + rb * rb)) / 6);
    if (!(p > 0)) {
        return mean;
    }
    const double det = x * (y * z - gb * gb) - rg * (rg * z - gb * rb) + rb * (rg * gb - y * rb);
    const double angle = std::acos(std::clamp(det / (2 * p * p * p), -1.0, 1.0)) / 3;
    return mean + 2 * p * std::cos(angle);
}

} // namespace

double determinant(const Jacobian& j) {
    return dot(j[0], cross(j[1], j[2]));
}

SingularValues singular_values(const Jacobian& j) {
    // Scaled to entries of at most 1, so that no power of them overflows or vanishes.
    double scale = 0;
    for (const RgbD& column : j) {
        scale = std::max({scale, std::abs(column.r), std::abs(column.g), std::abs(column.b)});
    }
    if (!(scale > 0)) {
        return {};
    }
    Jacobian unit;
    for (std::size_t c = 0; c < 3; ++c) {
        unit[c] = {j[c].r / scale, j[c].g / scale, j[c].b / scale};
    }
    const double first = std::sqrt(largest_of_gram(unit));
    const Jacobian cofactors{cross(unit[1], unit[2]), cross(unit[2], unit[0]),
                             cross(unit[0], unit[1])};
    const double first_two = std::sqrt(std::max(0.0, largest_of_gram(cofactors)));
    const double third = first_two > 0 ? std::abs(determinant(unit)) / first_two : 0;
    return {first * scale, std::min(third, first) * scale};
}

} // namespace lutlib
