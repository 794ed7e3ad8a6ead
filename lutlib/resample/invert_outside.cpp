#include "lutlib/resample/invert_outside.h"

#include "lutlib/interpolation/interpolation.h"

#include <array>
#include <cstdint>

namespace lutlib {
namespace {

RgbD products(const RgbD& a, const RgbD& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}

RgbD ratio(const RgbD& a, const RgbD& b) {
    const auto of = [](double x, double y) { return y > 0 ? x / y : 0; };
    return {of(a.r, b.r), of(a.g, b.g), of(a.b, b.b)};
}

// The shares that a sample has in open nodes, by their number among those.
struct Row {
    std::array<std::uint32_t, 4> open{};
    std::array<double, 4> weight{};
    std::size_t count = 0;
};

// Of all three channels at once: they share the matrix.
using Vector = std::vector<RgbD>;

RgbD squares(const Vector& v) {
    RgbD out;
    for (const RgbD& x : v) {
        out = out + products(x, x);
    }
    return out;
}

Vector applied(const std::vector<Row>& rows, const Vector& x) {
    Vector out(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < rows[i].count; ++k) {
            out[i] = out[i] + x[rows[i].open[k]] * rows[i].weight[k];
        }
    }
    return out;
}

Vector transposed(const std::vector<Row>& rows, const Vector& y, std::size_t size) {
    Vector out(size);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < rows[i].count; ++k) {
            RgbD& node = out[rows[i].open[k]];
            node = node + y[i] * rows[i].weight[k];
        }
    }
    return out;
}

void add(Vector& to, const Vector& from, const RgbD& times) {
    for (std::size_t i = 0; i < to.size(); ++i) {
        to[i] = to[i] + products(from[i], times);
    }
}

// A node's wish to stay, beside samples that weigh up to 1 each.
constexpr double stay = 1e-3;
constexpr int most_steps = 80;

// The change of the open nodes that leaves least of the residuals.
Vector least_squares(const std::vector<Row>& rows, Vector residual, std::size_t size) {
    Vector change(size);
    Vector gradient = transposed(rows, residual, size), direction = gradient;
    RgbD now = squares(gradient);
    const RgbD first = now;
    for (int step = 0; step < most_steps; ++step) {
        const Vector moved = applied(rows, direction);
        const RgbD bend = squares(moved) + squares(direction) * stay;
        const RgbD length = ratio(now, bend);
        add(change, direction, length);
        add(residual, moved, length * -1.0);
        gradient = transposed(rows, residual, size);
        add(gradient, change, RgbD{-stay, -stay, -stay});
        const RgbD next = squares(gradient);
        if (largest_magnitude(ratio(next, first)) < 1e-12) {
            break;
        }
        const RgbD keep = ratio(next, now);
        for (std::size_t i = 0; i < size; ++i) {
            direction[i] = gradient[i] + products(direction[i], keep);
        }
        now = next;
    }
    return change;
}

} // namespace

std::size_t fit_open_nodes(Lut3D& cube, const std::vector<bool>& open,
                           std::span<const InverseSample> samples) {
    constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> number(cube.nodes.size(), none);
    std::vector<std::size_t> nodes;
    std::vector<Row> rows;
    Vector residual;
    for (const InverseSample& sample : samples) {
        const NodeWeights weights =
            node_weights(Interpolation::tetrahedral, cube.size, sample.place);
        Row row;
        RgbD left = sample.wanted;
        for (std::size_t k = 0; k < weights.count; ++k) {
            const std::size_t node = weights.node[k];
            left = left - to_double(cube.nodes[node]) * weights.weight[k];
            if (!open[node]) {
                continue;
            }
            if (number[node] == none) {
                number[node] = static_cast<std::uint32_t>(nodes.size());
                nodes.push_back(node);
            }
            row.open[row.count] = number[node];
            row.weight[row.count++] = weights.weight[k];
        }
        if (row.count > 0) {
            rows.push_back(row);
            residual.push_back(left);
        }
    }
    const Vector change = least_squares(rows, std::move(residual), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        cube.nodes[nodes[i]] = to_float(to_double(cube.nodes[nodes[i]]) + change[i]);
    }
    return nodes.size();
}

} // namespace lutlib
