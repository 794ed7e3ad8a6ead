#include "lutlib/resample/invert_tetrahedron.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lutlib {
namespace {

double dot(RgbD a, RgbD b) {
    return a.r * b.r + a.g * b.g + a.b * b.b;
}

// A x = y of 1 to 3 unknowns, A symmetric and positive definite; by Cholesky's factors.
struct Normal {
    std::array<std::array<double, 3>, 3> a{};
    std::array<double, 3> y{};

    bool solve(std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k <= i; ++k) {
                double sum = a[i][k];
                for (std::size_t j = 0; j < k; ++j) {
                    sum -= a[i][j] * a[k][j];
                }
                if (i == k && !(sum > 0)) {
                    return false;
                }
                a[i][k] = i == k ? std::sqrt(sum) : sum / a[k][k];
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                y[i] -= a[i][j] * y[j];
            }
            y[i] /= a[i][i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t j = i + 1; j < n; ++j) {
                y[i] -= a[j][i] * y[j];
            }
            y[i] /= a[i][i];
        }
        return true;
    }
};

} // namespace

TetrahedronPoint nearest_in_tetrahedron(const std::array<RgbD, 4>& inputs,
                                        const std::array<RgbD, 4>& outputs, RgbD input, RgbD output,
                                        double span) {
    constexpr double rank = 1e8; // of the output before the input
    constexpr double slack = 1e-9;
    const double weight = span > 0 ? rank / (span * span) : 0;
    TetrahedronPoint best{inputs[0], outputs[0]};
    double least = std::numeric_limits<double>::infinity();
    // Each subset of the corners: the best point of the flat that it spans, if it lies between
    // them.
    for (unsigned subset = 1; subset < 16; ++subset) {
        std::array<std::size_t, 4> corner{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (subset >> i & 1U) {
                corner[count++] = i;
            }
        }
        const RgbD p0 = inputs[corner[0]], q0 = outputs[corner[0]];
        Normal normal;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const RgbD pi = inputs[corner[i + 1]] - p0, qi = outputs[corner[i + 1]] - q0;
            normal.y[i] = weight * dot(qi, output - q0) + dot(pi, input - p0);
            for (std::size_t k = 0; k <= i; ++k) {
                const RgbD pk = inputs[corner[k + 1]] - p0, qk = outputs[corner[k + 1]] - q0;
                normal.a[i][k] = weight * dot(qi, qk) + dot(pi, pk);
            }
        }
        if (!normal.solve(count - 1)) {
            continue;
        }
        double first = 1;
        bool inside = true;
        TetrahedronPoint at{p0, q0};
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const double share = normal.y[i];
            first -= share;
            inside = inside && share >= -slack;
            at.input = at.input + (inputs[corner[i + 1]] - p0) * share;
            at.output = at.output + (outputs[corner[i + 1]] - q0) * share;
        }
        if (!inside || first < -slack) {
            continue;
        }
        const RgbD dp = at.input - input, dq = at.output - output;
        const double cost = weight * dot(dq, dq) + dot(dp, dp);
        if (cost < least) {
            least = cost;
            best = at;
        }
    }
    return best;
}

} // namespace lutlib
