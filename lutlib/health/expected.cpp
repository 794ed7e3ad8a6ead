// The error that a coarser lattice is expected to make, from second differences.
//
// A straight line over an interval of length H misses a function of constant curvature by
// |f''|H^2/8 in its middle, which is half the second difference at the distance H/2. Tetrahedral
// interpolation draws such lines along the three axes, the diagonals of the cell's faces and its
// neutral diagonal. The second differences of the look's own nodes at a stride s near H/2 thus give
// the error, scaled by (H/2s)^2, as long as the curvature is the same at twice that stride. At a
// kink, a step or a spike it is not: the differences grow with the first power of the stride, or
// not at all. There the figure is the worst that the lattice's alignment can make of it, and is
// said to be unreliable.
#include "lutlib/health/parts.h"
#include "lutlib/interpolation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib::health {
namespace {

constexpr std::array<std::array<int, 3>, 7> edges{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
// Two strides may differ by this factor and still be called one curvature.
constexpr double agreement = 1.5;
constexpr int shaped_size = 65;

// The look over its own domain without a shaper.
Lut3D without_shaper(const Lut& lut) {
    Lut3D cube = identity_cube(shaped_size, lut.domain());
    for (Rgb& node : cube.nodes) {
        node = to_float(evaluate_exact(lut, to_double(node)));
    }
    return cube;
}

Extreme larger(const Extreme& a, const Extreme& b) {
    return b.value > a.value ? b : a;
}

// The largest second difference of any channel along any edge at this stride.
Extreme largest_difference(const Lut3D& cube, int stride) {
    const int last = cube.size - 1;
    const auto slab = [&](int b) {
        Extreme most;
        for (int g = 0; g <= last; ++g) {
            for (int r = 0; r <= last; ++r) {
                for (const auto& e : edges) {
                    const int dr = e[0] * stride, dg = e[1] * stride, db = e[2] * stride;
                    if (r < dr || g < dg || b < db || r + dr > last || g + dg > last ||
                        b + db > last) {
                        continue;
                    }
                    const RgbD d = to_double(cube.at(r - dr, g - dg, b - db)) -
                                   2 * to_double(cube.at(r, g, b)) +
                                   to_double(cube.at(r + dr, g + dg, b + db));
                    for (std::size_t c = 0; c < 3; ++c) {
                        if (std::abs(d[c]) > most.value && std::isfinite(d[c])) {
                            most = {std::abs(d[c]), to_float(node_position(cube, r, g, b))};
                        }
                    }
                }
            }
        }
        return most;
    };
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<int>(0, cube.size, 1), Extreme{},
        [&](const tbb::blocked_range<int>& range, Extreme most) {
            for (int b = range.begin(); b < range.end(); ++b) {
                most = larger(most, slab(b));
            }
            return most;
        },
        larger);
}

ExpectedError predict(const Lut3D& cube, int nodes, double rounding) {
    const double half_cell = (cube.size - 1) / (2.0 * (nodes - 1)); // H/2 in the look's own cells
    const int stride = std::max(1, static_cast<int>(std::lround(half_cell)));
    ExpectedError out{nodes, 0, false, {}};
    if (cube.size < 2 * stride + 1) {
        return out;
    }
    const auto estimate = [&](int s) {
        const Extreme d = largest_difference(cube, s);
        const double scale = half_cell / s;
        return Extreme{d.value * scale * scale / 2, d.in};
    };
    const Extreme usual = estimate(stride);
    out.error = usual.value;
    out.in = usual.in;
    if (cube.size < 4 * stride + 1) {
        return out;
    }
    // Four roundings meet in a second difference.
    const double floor = 2 * rounding * std::max(1.0, half_cell * half_cell);
    const auto agrees = [&](double other) {
        const double a = usual.value + floor, b = other + floor;
        return std::max(a, b) <= agreement * std::min(a, b);
    };
    out.reliable = agrees(estimate(2 * stride).value);
    if (!out.reliable) {
        // A kink's error grows with the length of the edge, not with its square.
        const double scale = half_cell / stride;
        out.error = std::max(usual.value, usual.value / std::max(scale, 1e-3));
    }
    return out;
}

} // namespace

void predict_errors(const Lut& lut, double rounding, Health& out) {
    const Lut3D shaped = lut.shaper || !lut.cube ? without_shaper(lut) : Lut3D{};
    const Lut3D& cube = shaped.size ? shaped : *lut.cube;
    for (ExpectedError& expected : out.expected) {
        expected = predict(cube, expected.nodes, rounding);
    }
}

} // namespace lutlib::health
