// The error that a lattice of another size is expected to make, from second differences.
//
// Where the curvature is locally constant, tetrahedral interpolation over cells of side H misses
// u = (u_r, u_g, u_b) within a cell by
//     H^2 ( sum_a f_aa u_a (1 - u_a) / 2  +  sum_{a<b} f_ab (min(u_a, u_b) - u_a u_b) )
// and a LUT, itself interpolated, is off from the smooth look through its nodes in the same way.
// The second differences of the nodes give f_aa and f_ab; at the look's own nodes, which is where
// it breaks, the formula gives the error against it. They are taken at a stride near H/2, as the
// error averages the curvature over a cell.
//
// That the curvature is constant is tested: the differences along the edges of the tetrahedra at
// twice the stride must say the same. At a kink, a step or a spike they do not: they grow with the
// first power of the stride, or not at all. There the figure is the worst that the lattice's
// alignment can make of it, and is said to be unreliable.
#include "lutlib/health/parts.h"
#include "lutlib/interpolation/interpolation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

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

// The largest channel of those that are finite.
double largest_finite(RgbD d) {
    double most = largest_magnitude(d);
    if (!std::isfinite(most)) {
        most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            most = std::isfinite(d[c]) ? std::max(most, std::abs(d[c])) : most;
        }
    }
    return most;
}

// The largest second difference of any channel along any edge at this stride.
Extreme largest_difference(const Lut3D& cube, int stride) {
    const int last = cube.size - 1;
    const auto slab = [&](int b) {
        Extreme most;
        for (int g = 0; g <= last; ++g) {
            const Rgb* const row = &cube.at(0, g, b);
            for (const auto& e : edges) {
                const int dr = e[0] * stride, dg = e[1] * stride, db = e[2] * stride;
                if (g < dg || b < db || g + dg > last || b + db > last) {
                    continue;
                }
                const auto step = static_cast<std::ptrdiff_t>(cube.index(dr, dg, db));
                for (int r = dr; r + dr <= last; ++r) {
                    const Rgb* const node = row + r;
                    const double d = largest_finite(to_double(node[-step]) - 2 * to_double(*node) +
                                                    to_double(node[step]));
                    if (d > most.value) {
                        most = {d, to_float(node_position(cube, r, g, b))};
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

// Position within a cell of a lattice: the cell's lower node and the fraction from there.
struct Phase {
    double low, fraction;
};

Phase phase_in(double nodes, double x) {
    const double at = x * (nodes - 1), low = std::floor(at + 1e-9);
    return {low / (nodes - 1), std::clamp(at - low, 0.0, 1.0)};
}

double along(double u) {
    return u * (1 - u) / 2;
}
double across(double u, double v) {
    return std::min(u, v) - u * v;
}

// The formula's weights of f_aa and f_ab, in squares of the look's own cells, for one node.
class Alignment {
  public:
    // `is_lattice`: the look is interpolated between its own nodes; else it is smooth.
    Alignment(int own, int nodes, bool is_lattice)
        : ratio_((own - 1.0) / (nodes - 1)), is_lattice_(is_lattice) {
        for (int i = 0; i < own; ++i) {
            const double x = i / (own - 1.0);
            const Phase phase = phase_in(nodes, x);
            const double high = std::min(phase.low + 1.0 / (nodes - 1), 1.0);
            axis_.push_back(
                {phase.fraction, phase_in(own, phase.low).fraction, phase_in(own, high).fraction});
        }
    }

    double axis(int i) const {
        const Axis& a = at(i);
        const double own = is_lattice_ ? (1 - a.u) * along(a.low) + a.u * along(a.high) : 0;
        return ratio_ * ratio_ * along(a.u) + own;
    }

    double pair(int i, int k) const {
        const Axis &a = at(i), &b = at(k);
        double own = 0;
        if (is_lattice_) {
            const double middle = a.u > b.u ? across(a.high, b.low) : across(a.low, b.high);
            own = (1 - std::max(a.u, b.u)) * across(a.low, b.low) + std::abs(a.u - b.u) * middle +
                  std::min(a.u, b.u) * across(a.high, b.high);
        }
        return ratio_ * ratio_ * across(a.u, b.u) + own;
    }

  private:
    // Where a node lies in its new cell, and where that cell's two ends lie in the look's cells.
    struct Axis {
        double u, low, high;
    };
    const Axis& at(int i) const { return axis_[static_cast<std::size_t>(i)]; }

    double ratio_;
    bool is_lattice_;
    std::vector<Axis> axis_;
};

// The largest error by the formula over all nodes.
Extreme by_formula(const Lut3D& cube, const Alignment& alignment, int stride) {
    const int n = cube.size, s = stride;
    const std::array<std::ptrdiff_t, 3> step{s, std::ptrdiff_t{s} * n, std::ptrdiff_t{s} * n * n};
    std::vector<double> axis, pair; // the weights of a node i, and of nodes i and k
    for (int i = 0; i < n; ++i) {
        axis.push_back(alignment.axis(i) / (s * s));
        for (int k = 0; k < n; ++k) {
            pair.push_back(alignment.pair(i, k) / (4.0 * s * s));
        }
    }
    const auto held = [&](int i) { return std::clamp(i, s, n - 1 - s); };
    const auto node = [&](int r, int g, int b) {
        const Rgb* const centre = &cube.at(held(r), held(g), held(b));
        const auto value = [centre](std::ptrdiff_t offset) { return to_double(centre[offset]); };
        const std::array<int, 3> at{r, g, b};
        const RgbD middle = 2 * to_double(*centre);
        RgbD error;
        for (std::size_t a = 0; a < 3; ++a) {
            const std::ptrdiff_t along = step[a];
            error = error +
                    axis[static_cast<std::size_t>(at[a])] * (value(-along) - middle + value(along));
            for (std::size_t c = a + 1; c < 3; ++c) {
                const std::ptrdiff_t both = along + step[c], apart = along - step[c];
                error = error + pair[static_cast<std::size_t>(at[a] * n + at[c])] *
                                    (value(both) - value(apart) - value(-apart) + value(-both));
            }
        }
        return Extreme{largest_finite(error), to_float(node_position(cube, r, g, b))};
    };
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<int>(0, n, 1), Extreme{},
        [&](const tbb::blocked_range<int>& range, Extreme most) {
            for (int b = range.begin(); b < range.end(); ++b) {
                for (int g = 0; g < n; ++g) {
                    for (int r = 0; r < n; ++r) {
                        most = larger(most, node(r, g, b));
                    }
                }
            }
            return most;
        },
        larger);
}

// largest_difference(), which two predictions may want at one stride.
class Differences {
  public:
    explicit Differences(const Lut3D& cube) : cube_(cube) {}

    const Extreme& at(int stride) {
        const auto [row, is_new] = known_.try_emplace(stride);
        if (is_new) {
            row->second = largest_difference(cube_, stride);
        }
        return row->second;
    }

  private:
    const Lut3D& cube_;
    std::map<int, Extreme> known_;
};

ExpectedError predict(const Lut3D& cube, Differences& differences, int nodes, bool is_lattice,
                      double rounding) {
    ExpectedError out{nodes, 0, true, {}};
    if (is_lattice && (nodes - 1) % (cube.size - 1) == 0) {
        return out; // every node of the look is kept, and nothing lies between them
    }
    const double half_cell = (cube.size - 1) / (2.0 * (nodes - 1)); // H/2 in the look's own cells
    const int stride = std::max(1, static_cast<int>(std::lround(half_cell)));
    if (cube.size < 2 * stride + 1) {
        out.reliable = false;
        return out;
    }
    const auto along_edges = [&](int s) {
        const Extreme& d = differences.at(s);
        const double scale = half_cell / s;
        return Extreme{d.value * scale * scale / 2, d.in};
    };
    const Extreme usual = along_edges(stride);
    // Four roundings meet in a second difference.
    const double floor = 2 * rounding * std::max(1.0, half_cell * half_cell);
    const auto agrees = [&](double other) {
        const double a = usual.value + floor, b = other + floor;
        return std::max(a, b) <= agreement * std::min(a, b);
    };
    out.reliable = cube.size >= 4 * stride + 1 && agrees(along_edges(2 * stride).value);
    if (out.reliable) {
        const Extreme most = by_formula(cube, Alignment(cube.size, nodes, is_lattice), stride);
        out.error = most.value;
        out.in = most.in;
    } else {
        // A kink's error grows with the length of the edge, not with its square.
        out.error = std::max(usual.value, usual.value * stride / half_cell);
        out.in = usual.in;
    }
    return out;
}

} // namespace

std::array<ExpectedError, 2> predict_errors(const Lut& lut, double rounding) {
    const Lut3D shaped = lut.shaper || !lut.cube ? without_shaper(lut) : Lut3D{};
    const Lut3D& cube = shaped.size ? shaped : *lut.cube;
    Differences differences(cube);
    const auto expected = [&](int nodes) {
        return predict(cube, differences, nodes, shaped.size == 0, rounding);
    };
    return {expected(16), expected(33)};
}

} // namespace lutlib::health
