#include "lutlib/match/residual_lattice.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/lut.h"
#include "lutlib/nodes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace lutlib {
namespace {

constexpr double fading = 1e-5;
constexpr int coarsest = 5, most_steps = 200;

// Nodes that have an entry in a node's row: those of the tetrahedra around it, and two steps along
// each axis, as second differences reach.
using Steps = std::array<int, 3>;
constexpr std::array<Steps, 21> neighbours{{
    {0, 0, 0},    {1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},   {1, 0, 1},   {0, 1, 1},
    {1, 1, 1},    {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {-1, -1, 0}, {-1, 0, -1}, {0, -1, -1},
    {-1, -1, -1}, {2, 0, 0},  {0, 2, 0},  {0, 0, 2},  {-2, 0, 0},  {0, -2, 0},  {0, 0, -2},
}};
using Row = std::array<double, neighbours.size()>;

// A value a node, and zeros before and behind them, so that every neighbour can be read.
class NodeValues {
  public:
    NodeValues(std::size_t nodes, std::size_t margin)
        : margin_(margin), values_(nodes + 2 * margin) {}

    RgbD& operator[](std::size_t node) { return values_[margin_ + node]; }
    const RgbD& operator[](std::size_t node) const { return values_[margin_ + node]; }
    const RgbD* at(std::size_t node) const { return &values_[margin_ + node]; }

  private:
    std::size_t margin_;
    std::vector<RgbD> values_;
};

RgbD product(RgbD a, RgbD b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}

// Of each channel; nothing where nothing is left to divide.
RgbD ratio(RgbD a, RgbD b) {
    const auto of = [](double x, double y) { return y > 0 ? x / y : 0; };
    return {of(a.r, b.r), of(a.g, b.g), of(a.b, b.b)};
}

class Equations {
  public:
    explicit Equations(int size)
        : size_(size), count_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) *
                              static_cast<std::size_t>(size)),
          rows_(count_), right_(values()) {
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            offsets_[i] = offset(neighbours[i]);
        }
    }

    NodeValues values() const {
        return {count_, 2 * static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_)};
    }
    std::size_t count() const { return count_; }
    double own(std::size_t node) const { return rows_[node][0]; }

    void add(const ColorPair& pair) {
        const NodeWeights weights =
            node_weights(Interpolation::tetrahedral, size_, (size_ - 1) * pair.before);
        for (std::size_t i = 0; i < weights.count; ++i) {
            const std::size_t node = weights.node[i];
            const double w = pair.weight * weights.weight[i];
            right_[node] = right_[node] + w * pair.after;
            for (std::size_t k = 0; k < weights.count; ++k) {
                rows_[node][neighbour(node, weights.node[k])] += w * weights.weight[k];
            }
        }
    }

    void add_smoothness(double smoothness) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Steps step{};
            step[axis] = 1;
            const std::ptrdiff_t along = offset(step);
            for_each_node(size_, [&](int r, int g, int b) {
                const int at = std::array{r, g, b}[axis];
                if (at > 0 && at + 1 < size_) {
                    add_bending(index(r, g, b), along, smoothness);
                }
            });
        }
        for (Row& row : rows_) {
            row[0] += fading;
        }
    }

    // The conjugate gradients of the three channels side by side, with each node's own entry as
    // preconditioner (Hestenes and Stiefel, 1952).
    NodeValues solved(NodeValues x, double precision) const {
        NodeValues residual = values(), direction = values(), image = values();
        multiply(x, image);
        RgbD whole, left;
        for (std::size_t k = 0; k < count_; ++k) {
            residual[k] = right_[k] - image[k];
            direction[k] = 1 / own(k) * residual[k];
            left = left + product(residual[k], direction[k]);
            whole = whole + 1 / own(k) * product(right_[k], right_[k]);
        }
        const RgbD enough = precision * precision * whole;
        for (int step = 0; step < most_steps && !is_below(left, enough); ++step) {
            multiply(direction, image);
            const RgbD along = sum([&](std::size_t k) { return product(direction[k], image[k]); });
            const RgbD by = ratio(left, along);
            const RgbD now = sum([&](std::size_t k) {
                x[k] = x[k] + product(by, direction[k]);
                residual[k] = residual[k] - product(by, image[k]);
                return 1 / own(k) * product(residual[k], residual[k]);
            });
            const RgbD kept = ratio(now, left);
            for_all([&](std::size_t k) {
                direction[k] = 1 / own(k) * residual[k] + product(kept, direction[k]);
            });
            left = now;
        }
        return x;
    }

  private:
    static bool is_below(RgbD a, RgbD b) { return a.r <= b.r && a.g <= b.g && a.b <= b.b; }

    std::size_t index(int r, int g, int b) const {
        const auto n = static_cast<std::size_t>(size_);
        return static_cast<std::size_t>(r) +
               n * (static_cast<std::size_t>(g) + n * static_cast<std::size_t>(b));
    }
    std::ptrdiff_t offset(const Steps& steps) const {
        return steps[0] + static_cast<std::ptrdiff_t>(size_) * (steps[1] + size_ * steps[2]);
    }

    // Which of the neighbours `other`, a corner of the same cell, is.
    std::size_t neighbour(std::size_t node, std::size_t other) const {
        const auto n = static_cast<std::size_t>(size_);
        const Steps steps{static_cast<int>(other % n) - static_cast<int>(node % n),
                          static_cast<int>(other / n % n) - static_cast<int>(node / n % n),
                          static_cast<int>(other / n / n) - static_cast<int>(node / n / n)};
        return static_cast<std::size_t>(std::find(neighbours.begin(), neighbours.end(), steps) -
                                        neighbours.begin());
    }

    void add_bending(std::size_t middle, std::ptrdiff_t along, double weight) {
        constexpr std::array<double, 3> difference{1, -2, 1};
        for (int i = -1; i <= 1; ++i) {
            const std::size_t node =
                static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + i * along);
            for (int k = -1; k <= 1; ++k) {
                const std::size_t entry = static_cast<std::size_t>(
                    std::find(offsets_.begin(), offsets_.end(), (k - i) * along) -
                    offsets_.begin());
                rows_[node][entry] += weight * difference[static_cast<std::size_t>(i + 1)] *
                                      difference[static_cast<std::size_t>(k + 1)];
            }
        }
    }

    template <class F>
    void for_all(F&& visit) const {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count_, 2048),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t k = range.begin(); k < range.end(); ++k) {
                                  visit(k);
                              }
                          });
    }
    // The same sum every time, however many cores there are.
    template <class F>
    RgbD sum(F&& of) const {
        return tbb::parallel_deterministic_reduce(
            tbb::blocked_range<std::size_t>(0, count_, 2048), RgbD{},
            [&](const tbb::blocked_range<std::size_t>& range, RgbD out) {
                for (std::size_t k = range.begin(); k < range.end(); ++k) {
                    out = out + of(k);
                }
                return out;
            },
            std::plus<>());
    }

    void multiply(const NodeValues& by, NodeValues& out) const {
        for_all([&](std::size_t k) {
            const Row& row = rows_[k];
            const RgbD* const at = by.at(k);
            RgbD value;
            for (std::size_t i = 0; i < neighbours.size(); ++i) {
                value = value + row[i] * at[offsets_[i]];
            }
            out[k] = value;
        });
    }

    int size_;
    std::size_t count_;
    std::array<std::ptrdiff_t, neighbours.size()> offsets_{};
    std::vector<Row> rows_;
    NodeValues right_;
};

// The nodes of a lattice of another size.
NodeValues carried_over(const NodeValues& from, int from_size, const Equations& to, int to_size) {
    NodeValues out = to.values();
    const double step = static_cast<double>(from_size - 1) / (to_size - 1);
    std::size_t node = 0;
    for_each_node(to_size, [&](int r, int g, int b) {
        const NodeWeights weights = node_weights(Interpolation::trilinear, from_size,
                                                 step * RgbD{double(r), double(g), double(b)});
        RgbD value;
        for (std::size_t i = 0; i < weights.count; ++i) {
            value = value + weights.weight[i] * from[weights.node[i]];
        }
        out[node++] = value;
    });
    return out;
}

} // namespace

ResidualLattice residual_lattice(std::span<const ColorPair> pairs, int size, double smoothness,
                                 double precision) {
    check_cube_size(size);
    std::vector<int> sizes{size};
    while (sizes.back() > 2 * coarsest) {
        sizes.push_back((sizes.back() + 1) / 2);
    }
    std::optional<NodeValues> start;
    int start_size = 0;
    ResidualLattice out;
    for (auto level = sizes.rbegin(); level != sizes.rend(); ++level) {
        Equations equations(*level);
        for (const ColorPair& pair : pairs) {
            equations.add(pair);
        }
        if (*level == size) {
            for (std::size_t k = 0; k < equations.count(); ++k) {
                out.support.push_back(equations.own(k));
            }
        }
        equations.add_smoothness(smoothness * (*level - 1) / 32);
        start = equations.solved(start ? carried_over(*start, start_size, equations, *level)
                                       : equations.values(),
                                 precision);
        start_size = *level;
    }
    for (std::size_t k = 0; k < out.support.size(); ++k) {
        out.nodes.push_back((*start)[k]);
    }
    return out;
}

} // namespace lutlib
