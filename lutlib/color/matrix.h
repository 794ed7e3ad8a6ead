// 3x3 matrices on colours: products and inverses in double, usable in constant expressions.
#pragma once

#include "lutlib/rgb.h"

#include <array>

namespace lutlib {

/// Row-major.
struct Matrix3 {
    std::array<std::array<double, 3>, 3> m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    friend constexpr RgbD operator*(const Matrix3& a, RgbD v) {
        return {a.m[0][0] * v.r + a.m[0][1] * v.g + a.m[0][2] * v.b,
                a.m[1][0] * v.r + a.m[1][1] * v.g + a.m[1][2] * v.b,
                a.m[2][0] * v.r + a.m[2][1] * v.g + a.m[2][2] * v.b};
    }
    friend constexpr Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
        Matrix3 out;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                out.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
            }
        }
        return out;
    }
    friend constexpr bool operator==(const Matrix3&, const Matrix3&) = default;
};

constexpr Matrix3 diagonal(RgbD d) {
    return {{{{d.r, 0, 0}, {0, d.g, 0}, {0, 0, d.b}}}};
}

constexpr double determinant(const Matrix3& a) {
    const auto& m = a.m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// By cofactors. The determinant must not be zero.
constexpr Matrix3 inverse(const Matrix3& a) {
    const auto& m = a.m;
    const double s = 1 / determinant(a);
    const auto minor = [&m, s](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return s * (m[i][j] * m[k][l] - m[i][l] * m[k][j]);
    };
    return {{{{minor(1, 1, 2, 2), minor(0, 2, 2, 1), minor(0, 1, 1, 2)},
              {minor(1, 2, 2, 0), minor(0, 0, 2, 2), minor(0, 2, 1, 0)},
              {minor(1, 0, 2, 1), minor(0, 1, 2, 0), minor(0, 0, 1, 1)}}}};
}

} // namespace lutlib
