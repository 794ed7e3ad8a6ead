// Cells of a cube and the tetrahedra within, for the search of inverses.
#pragma once

#include "lutlib/color/matrix.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/lut.h"

#include <array>
#include <cmath>

namespace lutlib {

/// In nodes, 0 .. size-1.
using Place = std::array<double, 3>;

/// By its lower node.
struct Cell {
    int r, g, b;
};

inline double square(RgbD d) {
    return d.r * d.r + d.g * d.g + d.b * d.b;
}

/// The four corners' outputs along a path.
inline std::array<RgbD, 4> corners(const Lut3D& cube, Cell cell, const Walk& path) {
    std::array<int, 3> node{cell.r, cell.g, cell.b};
    std::array<RgbD, 4> out{to_double(cube.at(node[0], node[1], node[2]))};
    for (std::size_t step = 0; step < 3; ++step) {
        ++node[path[step]];
        out[step + 1] = to_double(cube.at(node[0], node[1], node[2]));
    }
    return out;
}

/// d output / d place within a tetrahedron: the column of axis path[i] is corner i+1 minus corner
/// i.
inline Matrix3 slope(const std::array<RgbD, 4>& corner, const Walk& path) {
    Matrix3 m;
    for (std::size_t step = 0; step < 3; ++step) {
        const RgbD d = corner[step + 1] - corner[step];
        for (std::size_t c = 0; c < 3; ++c) {
            m.m[c][path[step]] = d[c];
        }
    }
    return m;
}

/// Whether the volume that the outputs' edges span is no more than two independent roundings make
/// of it.
inline bool is_flat(const Matrix3& m, double rounding) {
    RgbD length;
    for (std::size_t i = 0; i < 3; ++i) {
        length[i] = std::sqrt(square({m.m[0][i], m.m[1][i], m.m[2][i]}));
    }
    const double faces = length.r * length.g + length.g * length.b + length.b * length.r;
    return !(std::abs(determinant(m)) > 1.6 * rounding * faces);
}

} // namespace lutlib
