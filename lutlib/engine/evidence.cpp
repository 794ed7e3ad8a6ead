#include "lutlib/engine/evidence.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

using Axes = std::array<RgbD, 3>; ///< a colour for each axis of the lattice

double squared(RgbD c) {
    return c.r * c.r + c.g * c.g + c.b * c.b;
}

// The slope of each channel along each axis by least squares. The nodes are a full grid, so the
// axes do not disturb each other.
Axes slopes_of(const Lut3D& cube) {
    Axes out{};
    const int n = cube.size;
    const double middle = (n - 1) / 2.0;
    double spread = 0;
    auto node = cube.nodes.begin();
    for (int b = 0; b < n; ++b) {
        for (int g = 0; g < n; ++g) {
            for (int r = 0; r < n; ++r, ++node) {
                const RgbD value = to_double(*node);
                out[0] = out[0] + value * (r - middle);
                out[1] = out[1] + value * (g - middle);
                out[2] = out[2] + value * (b - middle);
                spread += (r - middle) * (r - middle);
            }
        }
    }
    for (RgbD& slope : out) {
        slope = slope * ((n - 1) / spread);
    }
    return out;
}

void measure_steps(const Lut3D& cube, Evidence& out) {
    const int n = cube.size;
    RgbD sum, squares;
    for (const Rgb& node : cube.nodes) {
        const RgbD value = to_double(node);
        sum = sum + value;
        squares = squares + RgbD{value.r * value.r, value.g * value.g, value.b * value.b};
    }
    const auto count = static_cast<double>(cube.nodes.size());
    const double variance =
        (squares.r + squares.g + squares.b) / count - squared(sum) / (count * count);
    // Rounding to codes alone gives no shape.
    constexpr double one_color = 1e-7;
    if (!(variance > one_color)) {
        return;
    }
    const std::array<std::size_t, 3> step{1, cube.index(0, 1, 0), cube.index(0, 0, 1)};
    std::array<double, 3> moved{};
    for (int b = 0; b < n; ++b) {
        for (int g = 0; g < n; ++g) {
            for (int r = 0; r < n; ++r) {
                const std::array<int, 3> at{r, g, b};
                const std::size_t here = cube.index(r, g, b);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (at[axis] + 1 < n) {
                        moved[axis] +=
                            squared(to_double(cube.nodes[here + step[axis]] - cube.nodes[here]));
                    }
                }
            }
        }
    }
    const double steps = count / n * (n - 1);
    out.step = (moved[0] + moved[1] + moved[2]) / (3 * steps);
    out.roughness = std::max({moved[0], moved[1], moved[2]}) / steps / (2 * variance);
}

// A colour's part along the grey axis, and its two coordinates across (an orthonormal basis).
struct Split {
    double grey, u, v;
};
Split split(RgbD c) {
    return {(c.r + c.g + c.b) / std::sqrt(3.0), (2 * c.r - c.g - c.b) / std::sqrt(6.0),
            (c.g - c.b) / std::sqrt(2.0)};
}

} // namespace

bool falls(const Evidence& evidence) {
    return *std::max_element(evidence.tone.begin(), evidence.tone.end()) < -tone_slack;
}

Evidence evidence_of(const Lut3D& cube) {
    Evidence out;
    measure_steps(cube, out);
    const Axes slopes = slopes_of(cube);
    const double all = squared(slopes[0]) + squared(slopes[1]) + squared(slopes[2]);
    if (!(all > 0)) {
        return out;
    }
    // What the map makes of the unit colours along and across the grey axis.
    const auto mapped = [&](RgbD in) {
        return split(slopes[0] * in.r + slopes[1] * in.g + slopes[2] * in.b);
    };
    const Split grey = mapped(RgbD{1, 1, 1} * (1 / std::sqrt(3.0)));
    const Split u = mapped(RgbD{2, -1, -1} * (1 / std::sqrt(6.0)));
    const Split v = mapped(RgbD{0, 1, -1} * (1 / std::sqrt(2.0)));
    const double across = u.u * u.u + u.v * u.v + v.u * v.u + v.v * v.v;
    const double drift = std::hypot(grey.u, grey.v);
    out.color = std::sqrt((across + drift * drift) / all);
    out.grey_drift = across > 0 ? drift / std::sqrt(across / 2) : 1;
    out.hue_order = across > 0 ? 2 * (u.u * v.v - u.v * v.u) / across : 0;
    double own = 0, travel = 0, most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const RgbD s = slopes[axis];
        own += s[axis];
        travel += std::abs(s.r) + std::abs(s.g) + std::abs(s.b);
        out.tone[axis] = (s.r + s.g + s.b) / 3;
        most = std::max(most, std::abs(out.tone[axis]));
    }
    out.ownership = own / travel;
    for (double& slope : out.tone) {
        slope = most > 0 ? slope / most : 0;
    }
    return out;
}

} // namespace lutlib
