#include "lutlib/interpolation/tricubic.h"

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

// Four nodes of an axis and their weights. The weight of a node beyond a face is shared out among
// the nodes that the parabola (of two nodes: the line) which gives its value passes through.
struct Taps {
    std::array<int, 4> node;
    std::array<double, 4> weight;
};

Taps taps(double value, float min, float max, int size) {
    const double t =
        (value - static_cast<double>(min)) / (static_cast<double>(max) - static_cast<double>(min));
    const double x = (t > 0 ? std::min(t, 1.0) : 0.0) * (size - 1);
    const int i = std::min(static_cast<int>(x), size - 2);
    const double f = x - i, f2 = f * f, f3 = f2 * f;
    Taps out{{i - 1, i, i + 1, i + 2},
             {-0.5 * f3 + f2 - 0.5 * f, 1.5 * f3 - 2.5 * f2 + 1, -1.5 * f3 + 2 * f2 + 0.5 * f,
              0.5 * f3 - 0.5 * f2}};
    const auto share = [&](std::size_t outer, std::size_t next, std::size_t inner,
                           std::size_t innermost) {
        const double w = out.weight[outer];
        out.weight[outer] = 0;
        out.node[outer] = out.node[next];
        if (size == 2) {
            out.weight[next] += 2 * w;
            out.weight[inner] -= w;
        } else {
            out.weight[next] += 3 * w;
            out.weight[inner] -= 3 * w;
            out.weight[innermost] += w;
        }
    };
    if (i == 0) {
        share(0, 1, 2, 3);
    }
    if (i == size - 2) {
        share(3, 2, 1, 0);
    }
    return out;
}

} // namespace

RgbD tricubic(const Lut3D& cube, RgbD in) {
    const Domain& d = cube.domain;
    const Taps r = taps(in.r, d.min.r, d.max.r, cube.size);
    const Taps g = taps(in.g, d.min.g, d.max.g, cube.size);
    const Taps b = taps(in.b, d.min.b, d.max.b, cube.size);
    RgbD sum;
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t j = 0; j < 4; ++j) {
            const double weight = b.weight[k] * g.weight[j];
            if (weight == 0) {
                continue;
            }
            for (std::size_t i = 0; i < 4; ++i) {
                sum = sum +
                      weight * r.weight[i] * to_double(cube.at(r.node[i], g.node[j], b.node[k]));
            }
        }
    }
    return sum;
}

} // namespace lutlib
