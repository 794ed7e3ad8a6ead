#include "lutlib/interpolation/interpolation.h"

#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array<InterpolationInfo, 3> interpolation_rows{{
    {Interpolation::nearest, "nearest", "the nearest node, unfiltered"},
    {Interpolation::trilinear, "trilinear", "eight nodes, what texture units do"},
    {Interpolation::tetrahedral, "tetrahedral", "four nodes, exact on the neutral axis"},
}};

// Index of the cell's lower node and the fraction within the cell, both from one clamped value, so
// that no rounding can make them disagree.
template <class T>
struct CellAxis {
    int i;
    T f;
};

// `value` in units of nodes, 0 .. size-1. The comparison's form sends NaN to 0.
template <class T>
T lattice_coordinate(T value, float min, float max, int size) {
    const T t = (value - static_cast<T>(min)) / (static_cast<T>(max) - static_cast<T>(min));
    return (t > T{0} ? std::min(t, T{1}) : T{0}) * static_cast<T>(size - 1);
}

template <class T>
CellAxis<T> locate(T value, float min, float max, int size) {
    const T x = lattice_coordinate(value, min, max, size);
    const int i = std::min(static_cast<int>(x), size - 2);
    return {i, x - static_cast<T>(i)};
}

template <class T>
std::array<CellAxis<T>, 3> locate(const Lut3D& cube, BasicRgb<T> in) {
    const Domain& d = cube.domain;
    return {locate(in.r, d.min.r, d.max.r, cube.size), locate(in.g, d.min.g, d.max.g, cube.size),
            locate(in.b, d.min.b, d.max.b, cube.size)};
}

template <class T>
const Rgb& nearest_node(const Lut3D& cube, BasicRgb<T> in) {
    const auto index = [&](std::size_t c) {
        const T x = lattice_coordinate(in[c], cube.domain.min[c], cube.domain.max[c], cube.size);
        return static_cast<int>(x + T{0.5});
    };
    return cube.at(index(0), index(1), index(2));
}

// Two products rather than a + (b-a)*t: b-a may overflow, and t = 1 must give b exactly.
Rgb mix(Rgb a, Rgb b, float t) {
    return a * (1 - t) + b * t;
}

Rgb trilinear(const Lut3D& cube, Rgb in) {
    const auto [r, g, b] = locate(cube, in);
    const Rgb c00 = mix(cube.at(r.i, g.i, b.i), cube.at(r.i + 1, g.i, b.i), r.f);
    const Rgb c10 = mix(cube.at(r.i, g.i + 1, b.i), cube.at(r.i + 1, g.i + 1, b.i), r.f);
    const Rgb c01 = mix(cube.at(r.i, g.i, b.i + 1), cube.at(r.i + 1, g.i, b.i + 1), r.f);
    const Rgb c11 = mix(cube.at(r.i, g.i + 1, b.i + 1), cube.at(r.i + 1, g.i + 1, b.i + 1), r.f);
    return mix(mix(c00, c10, g.f), mix(c01, c11, g.f), b.f);
}

// Walks from the cell's dark corner to its bright one along the axes in order of falling fraction;
// the six orders are the six tetrahedra.
Rgb tetrahedral(const Lut3D& cube, Rgb in) {
    const auto [r, g, b] = locate(cube, in);
    const auto corner = [&cube, r = r.i, g = g.i, b = b.i](int dr, int dg, int db) {
        return cube.at(r + dr, g + dg, b + db);
    };
    const auto walk = [&](float hi, float mid, float lo, Rgb first, Rgb second) {
        return corner(0, 0, 0) * (1 - hi) + first * (hi - mid) + second * (mid - lo) +
               corner(1, 1, 1) * lo;
    };
    if (r.f > g.f) {
        if (g.f > b.f) {
            return walk(r.f, g.f, b.f, corner(1, 0, 0), corner(1, 1, 0));
        }
        if (r.f > b.f) {
            return walk(r.f, b.f, g.f, corner(1, 0, 0), corner(1, 0, 1));
        }
        return walk(b.f, r.f, g.f, corner(0, 0, 1), corner(1, 0, 1));
    }
    if (b.f > g.f) {
        return walk(b.f, g.f, r.f, corner(0, 0, 1), corner(0, 1, 1));
    }
    if (b.f > r.f) {
        return walk(g.f, b.f, r.f, corner(0, 1, 0), corner(0, 1, 1));
    }
    return walk(g.f, r.f, b.f, corner(0, 1, 0), corner(1, 1, 0));
}

RgbD trilinear_exact(const Lut3D& cube, RgbD in) {
    const auto [r, g, b] = locate(cube, in);
    RgbD sum;
    for (int corner = 0; corner < 8; ++corner) {
        const int dr = corner & 1, dg = (corner >> 1) & 1, db = corner >> 2;
        const double weight = (dr ? r.f : 1 - r.f) * (dg ? g.f : 1 - g.f) * (db ? b.f : 1 - b.f);
        sum = sum + weight * to_double(cube.at(r.i + dr, g.i + dg, b.i + db));
    }
    return sum;
}

RgbD tetrahedral_exact(const Lut3D& cube, RgbD in) {
    const auto [r, g, b] = locate(cube, in);
    const std::array<double, 3> f{r.f, g.f, b.f};
    const auto n = static_cast<std::size_t>(cube.size);
    const std::array<std::size_t, 3> stride{1, n, n * n};
    const auto [first, second, third] = axes_by_fraction(f);
    const Rgb* node = &cube.at(r.i, g.i, b.i);
    RgbD sum = (1 - f[first]) * to_double(*node);
    node += stride[first];
    sum = sum + (f[first] - f[second]) * to_double(*node);
    node += stride[second];
    sum = sum + (f[second] - f[third]) * to_double(*node);
    node += stride[third];
    return sum + f[third] * to_double(*node);
}

void add_node(NodeWeights& out, std::size_t node, double weight) {
    if (weight > 0) {
        out.node[out.count] = node;
        out.weight[out.count++] = weight;
    }
}

template <class T>
BasicRgb<T> evaluate_curve(const Lut1D& curve, BasicRgb<T> in) {
    BasicRgb<T> out;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [i, f] = locate(in[c], curve.domain.min[c], curve.domain.max[c], curve.size());
        const auto k = static_cast<std::size_t>(i);
        const T low = static_cast<T>(curve.entries[k][c]);
        const T high = static_cast<T>(curve.entries[k + 1][c]);
        out[c] = low * (1 - f) + high * f;
    }
    return out;
}

} // namespace

std::span<const InterpolationInfo> interpolations() {
    return interpolation_rows;
}

std::optional<Interpolation> interpolation_named(std::string_view name) {
    const InterpolationInfo* const row = find_named(interpolation_rows, name);
    return row ? std::optional(row->kind) : std::nullopt;
}

std::string_view name_of(Interpolation kind) {
    for (const InterpolationInfo& row : interpolation_rows) {
        if (row.kind == kind) {
            return row.name;
        }
    }
    return {};
}

NodeWeights node_weights(Interpolation how, int size, RgbD place) {
    const auto n = static_cast<std::size_t>(size);
    const std::array<std::size_t, 3> stride{1, n, n * n};
    const auto last = static_cast<float>(size - 1);
    std::size_t first = 0;
    std::array<double, 3> f{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto axis = locate(place[c], 0.0F, last, size);
        first += static_cast<std::size_t>(axis.i) * stride[c];
        f[c] = axis.f;
    }
    NodeWeights out;
    if (how == Interpolation::nearest) {
        for (std::size_t c = 0; c < 3; ++c) {
            first += f[c] >= 0.5 ? stride[c] : 0;
        }
        add_node(out, first, 1);
    } else if (how == Interpolation::trilinear) {
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const bool r = corner & 1, g = corner & 2, b = corner & 4;
            add_node(out, first + (r ? stride[0] : 0) + (g ? stride[1] : 0) + (b ? stride[2] : 0),
                     (r ? f[0] : 1 - f[0]) * (g ? f[1] : 1 - f[1]) * (b ? f[2] : 1 - f[2]));
        }
    } else {
        const auto order = axes_by_fraction(f);
        add_node(out, first, 1 - f[order[0]]);
        for (std::size_t step = 0; step < 3; ++step) {
            first += stride[order[step]];
            add_node(out, first, f[order[step]] - (step < 2 ? f[order[step + 1]] : 0.0));
        }
    }
    return out;
}

Rgb evaluate(const Lut1D& curve, Rgb in) {
    return evaluate_curve(curve, in);
}

Rgb evaluate(const Lut3D& cube, Rgb in, Interpolation how) {
    switch (how) {
    case Interpolation::nearest:
        return nearest_node(cube, in);
    case Interpolation::trilinear:
        return trilinear(cube, in);
    case Interpolation::tetrahedral:
        break;
    }
    return tetrahedral(cube, in);
}

Rgb evaluate(const Lut& lut, Rgb in, Interpolation how) {
    const Rgb shaped = lut.shaper ? evaluate(*lut.shaper, in) : in;
    return lut.cube ? evaluate(*lut.cube, shaped, how) : shaped;
}

RgbD evaluate_exact(const Lut1D& curve, RgbD in) {
    return evaluate_curve(curve, in);
}

RgbD evaluate_exact(const Lut3D& cube, RgbD in, Interpolation how) {
    switch (how) {
    case Interpolation::nearest:
        return to_double(nearest_node(cube, in));
    case Interpolation::trilinear:
        return trilinear_exact(cube, in);
    case Interpolation::tetrahedral:
        break;
    }
    return tetrahedral_exact(cube, in);
}

RgbD evaluate_exact(const Lut& lut, RgbD in, Interpolation how) {
    const RgbD shaped = lut.shaper ? evaluate_exact(*lut.shaper, in) : in;
    return lut.cube ? evaluate_exact(*lut.cube, shaped, how) : shaped;
}

Interpolation usual_interpolation(const Lut& lut) {
    return lut.interpolation.value_or(Interpolation::tetrahedral);
}

Rgb evaluate(const Lut& lut, Rgb in) {
    return evaluate(lut, in, usual_interpolation(lut));
}

RgbD evaluate_exact(const Lut& lut, RgbD in) {
    return evaluate_exact(lut, in, usual_interpolation(lut));
}

} // namespace lutlib
