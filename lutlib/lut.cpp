#include "lutlib/lut.h"

#include "lutlib/error.h"
#include "lutlib/limits.h"

#include <cmath>

namespace lutlib {
namespace {

double position(float min, float max, int i, int size) {
    const double t = static_cast<double>(i) / (size - 1);
    return static_cast<double>(min) + t * (static_cast<double>(max) - static_cast<double>(min));
}

bool finite(const Rgb& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

void check_finite(const std::vector<Rgb>& values, const char* what) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!finite(values[i])) {
            throw Error(std::string(what) + " " + std::to_string(i) +
                        " is not finite; every value must be a number");
        }
    }
}

std::string range_text(int low, int high) {
    return std::to_string(low) + " to " + std::to_string(high);
}

} // namespace

const Domain& Lut::domain() const {
    static const Domain unit;
    return shaper ? shaper->domain : cube ? cube->domain : unit;
}

RgbD node_position(const Lut3D& cube, int r, int g, int b) {
    const Domain& d = cube.domain;
    return {position(d.min.r, d.max.r, r, cube.size), position(d.min.g, d.max.g, g, cube.size),
            position(d.min.b, d.max.b, b, cube.size)};
}

RgbD entry_position(const Lut1D& curve, int i) {
    const Domain& d = curve.domain;
    return {position(d.min.r, d.max.r, i, curve.size()),
            position(d.min.g, d.max.g, i, curve.size()),
            position(d.min.b, d.max.b, i, curve.size())};
}

Lut3D identity_cube(int size, const Domain& domain) {
    check_cube_size(size);
    check_domain(domain);
    Lut3D cube{domain, size, {}};
    const auto n = static_cast<std::size_t>(size);
    cube.nodes.reserve(n * n * n);
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                cube.nodes.push_back(to_float(node_position(cube, r, g, b)));
            }
        }
    }
    return cube;
}

void check_cube_size(long long size) {
    if (size < limits::min_cube_size || size > limits::max_cube_size) {
        throw Error("the 3D size " + std::to_string(size) + " is outside " +
                    range_text(limits::min_cube_size, limits::max_cube_size));
    }
}

void check_shaper_size(long long size) {
    if (size < limits::min_shaper_size || size > limits::max_shaper_size) {
        throw Error("the 1D size " + std::to_string(size) + " is outside " +
                    range_text(limits::min_shaper_size, limits::max_shaper_size));
    }
}

void check_domain(const Domain& domain) {
    for (std::size_t c = 0; c < 3; ++c) {
        const float width = domain.max[c] - domain.min[c];
        if (width > 0 && !std::isfinite(width)) {
            throw Error(std::string("the domain of channel ") + "rgb"[c] +
                        " is wider than a float can say; choose a narrower one");
        }
        if (!(width > 0)) {
            throw Error(std::string("the domain of channel ") + "rgb"[c] + " runs from " +
                        std::to_string(domain.min[c]) + " to " + std::to_string(domain.max[c]) +
                        "; its minimum must lie below its maximum");
        }
    }
}

void validate(const Lut& lut) {
    if (lut.shaper) {
        check_shaper_size(lut.shaper->size());
        check_domain(lut.shaper->domain);
        check_finite(lut.shaper->entries, "curve entry");
    }
    if (lut.cube) {
        check_cube_size(lut.cube->size);
        check_domain(lut.cube->domain);
        const auto n = static_cast<std::size_t>(lut.cube->size);
        if (lut.cube->nodes.size() != n * n * n) {
            throw Error("a cube of size " + std::to_string(n) + " has " +
                        std::to_string(lut.cube->nodes.size()) + " nodes; it needs " +
                        std::to_string(n * n * n));
        }
        check_finite(lut.cube->nodes, "node");
    }
}

} // namespace lutlib
