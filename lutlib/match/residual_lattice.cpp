#include "lutlib/match/residual_lattice.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/lut.h"
#include "lutlib/match/symmetric_product.h"
#include "lutlib/nodes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <functional>

namespace lutlib {
namespace {

// Of the smoothness: however stiff, a lattice reaches as far beyond what is known.
constexpr double fading = 1e-4;
constexpr int coarsest = 5, most_steps = 200, most_rounds = 8, kink_rounds = 4;
// Of a pair that the lattice goes beyond: nothing else says how far.
constexpr double still = 0.01;
// While kinks are still looked for.
constexpr double on_the_way = 3e-3;
// Of the pairs that were clipped, so few that still change sides are let be.
constexpr std::size_t few = 200;

// Nodes behind a node that have an entry in its row: those of the tetrahedra around it, and two
// steps along each axis, as second differences reach. Those before it have theirs by symmetry.
using Steps = std::array<int, 3>;
constexpr std::array<Steps, 11> neighbours{{{0, 0, 0},
                                            {1, 0, 0},
                                            {0, 1, 0},
                                            {0, 0, 1},
                                            {1, 1, 0},
                                            {1, 0, 1},
                                            {0, 1, 1},
                                            {1, 1, 1},
                                            {2, 0, 0},
                                            {0, 2, 0},
                                            {0, 0, 2}}};

// A value a node, and zeros before and behind them, so that every neighbour can be read.
class NodeValues {
  public:
    NodeValues() = default;
    explicit NodeValues(int size)
        : margin_(2 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size)),
          values_(margin_ / 2 * static_cast<std::size_t>(size) + 2 * margin_) {}

    double* data() { return values_.data() + margin_; }
    const double* data() const { return values_.data() + margin_; }
    double& operator[](std::size_t node) { return data()[node]; }
    double operator[](std::size_t node) const { return data()[node]; }

  private:
    std::size_t margin_ = 0;
    std::vector<double> values_;
};

// A pair and its share of each node.
struct Placed {
    std::array<std::size_t, 4> node{};
    std::array<double, 4> share{};
    double weight = 0;
    RgbD after;
    Clipped clipped{};

    Placed(const ColorPair& pair, int size)
        : weight(pair.weight), after(pair.after), clipped(pair.clipped) {
        const NodeWeights at =
            node_weights(Interpolation::tetrahedral, size, (size - 1) * pair.before);
        for (std::size_t i = 0; i < at.count; ++i) {
            node[i] = at.node[i];
            share[i] = at.weight[i];
        }
    }
    double read(const NodeValues& from) const {
        double out = 0;
        for (std::size_t i = 0; i < node.size(); ++i) {
            out += share[i] * from[node[i]];
        }
        return out;
    }
    // Whether a channel of what is read costs something.
    bool counts(std::size_t channel, double read) const {
        return clipped[channel] == 0 || (after[channel] - read) * clipped[channel] > 0;
    }
};

// The left side, by diagonals.
class Matrix {
  public:
    explicit Matrix(int size) : size_(size) {
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            offsets_[i] = offset(neighbours[i]);
            diagonals_[i] = NodeValues(size);
        }
    }

    double own(std::size_t node) const { return diagonals_[0][node]; }

    void add(const Placed& pair, double share = 1) {
        for (std::size_t i = 0; i < pair.node.size(); ++i) {
            for (std::size_t k = 0; k < pair.node.size(); ++k) {
                const double entry = share * pair.weight * pair.share[i] * pair.share[k];
                if (entry > 0 && pair.node[k] >= pair.node[i]) {
                    diagonal(static_cast<std::ptrdiff_t>(pair.node[k] -
                                                         pair.node[i]))[pair.node[i]] += entry;
                }
            }
        }
    }

    // bend(node, along) is what the second difference about the node behind `node` weighs.
    template <class F>
    void add_smoothness(double fade, F&& bend) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Steps step{};
            step[axis] = 1;
            const std::ptrdiff_t along = offset(step);
            const auto to_next = static_cast<std::size_t>(along);
            double *const own = diagonals_[0].data(), *const next = diagonal(along).data(),
                          *const behind = diagonal(2 * along).data();
            std::size_t node = 0;
            for_each_node(size_, [&](int r, int g, int b) {
                if (const int at = std::array{r, g, b}[axis]; at + 2 < size_) {
                    const double weight = bend(node, to_next);
                    const std::size_t middle = node + to_next, last = middle + to_next;
                    own[node] += weight;
                    own[middle] += 4 * weight;
                    own[last] += weight;
                    next[node] -= 2 * weight;
                    next[middle] -= 2 * weight;
                    behind[node] += weight;
                }
                ++node;
            });
        }
        for (std::size_t k = 0; k < count(); ++k) {
            diagonals_[0][k] += fade;
        }
    }

    // The conjugate gradients, with each node's own entry as preconditioner (Hestenes and Stiefel,
    // 1952).
    void solve(const NodeValues& right, NodeValues& x, double precision) const {
        NodeValues residual(size_), direction(size_), image(size_);
        multiply(x, image);
        double whole = 0, left = 0;
        for (std::size_t k = 0; k < count(); ++k) {
            residual[k] = right[k] - image[k];
            direction[k] = residual[k] / own(k);
            left += residual[k] * direction[k];
            whole += right[k] * right[k] / own(k);
        }
        const double enough = precision * precision * whole;
        for (int step = 0; step < most_steps && left > enough; ++step) {
            multiply(direction, image);
            const double along = sum([&](std::size_t k) { return direction[k] * image[k]; });
            const double by = left / along;
            const double now = sum([&](std::size_t k) {
                x[k] += by * direction[k];
                residual[k] -= by * image[k];
                return residual[k] * residual[k] / own(k);
            });
            const double carried = now / left;
            for_all([&](std::size_t k) {
                direction[k] = residual[k] / own(k) + carried * direction[k];
            });
            left = now;
        }
    }

  private:
    std::size_t count() const {
        const auto n = static_cast<std::size_t>(size_);
        return n * n * n;
    }
    std::ptrdiff_t offset(const Steps& steps) const {
        return steps[0] + static_cast<std::ptrdiff_t>(size_) * (steps[1] + size_ * steps[2]);
    }
    // Of equal offsets of tiny lattices, the tetrahedron's.
    NodeValues& diagonal(std::ptrdiff_t offset) {
        return diagonals_[static_cast<std::size_t>(
            std::find(offsets_.begin(), offsets_.end(), offset) - offsets_.begin())];
    }

    template <class F>
    void for_all(F&& visit) const {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count(), 4096),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t k = range.begin(); k < range.end(); ++k) {
                                  visit(k);
                              }
                          });
    }
    // The same sum every time, however many cores there are.
    template <class F>
    double sum(F&& of) const {
        return tbb::parallel_deterministic_reduce(
            tbb::blocked_range<std::size_t>(0, count(), 4096), 0.0,
            [&](const tbb::blocked_range<std::size_t>& range, double out) {
                for (std::size_t k = range.begin(); k < range.end(); ++k) {
                    out += of(k);
                }
                return out;
            },
            std::plus<>());
    }

    void multiply(const NodeValues& by, NodeValues& out) const {
        std::array<Diagonal, neighbours.size() - 1> beside;
        for (std::size_t i = 0; i < beside.size(); ++i) {
            beside[i] = {diagonals_[i + 1].data(), offsets_[i + 1]};
        }
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count(), 4096),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              symmetric_product(diagonals_[0].data(), beside, by.data(), out.data(),
                                                range.begin(), range.end());
                          });
    }

    int size_;
    std::array<std::ptrdiff_t, neighbours.size()> offsets_{};
    std::array<NodeValues, neighbours.size()> diagonals_;
};

using Channels = std::array<NodeValues, 3>;

// The nodes of a lattice of another size.
NodeValues carried_over(const NodeValues& from, int from_size, int to_size) {
    NodeValues out(to_size);
    const double step = static_cast<double>(from_size - 1) / (to_size - 1);
    std::size_t node = 0;
    for_each_node(to_size, [&](int r, int g, int b) {
        const NodeWeights weights = node_weights(Interpolation::trilinear, from_size,
                                                 step * RgbD{double(r), double(g), double(b)});
        for (std::size_t i = 0; i < weights.count; ++i) {
            out[node] += weights.weight[i] * from[weights.node[i]];
        }
        ++node;
    });
    return out;
}

// A channel of one lattice, from where it starts. Pairs that were clipped take part while the
// lattice does not go beyond them (Newton's method for the square of a hinge: O. Mangasarian, "A
// finite Newton method for classification", Optimization Methods and Software 17(5), 2002).
class ChannelFit {
  public:
    ChannelFit(const std::vector<Placed>& pairs, int size, std::size_t channel)
        : size_(size), channel_(channel), left_(size), right_(size) {
        for (const Placed& pair : pairs) {
            if (pair.clipped[channel] == 0) {
                left_.add(pair);
                add_right(pair, right_);
            } else {
                clipped_.push_back(&pair);
            }
        }
    }

    void run(double smoothness, double kink, double precision, NodeValues& nodes) const {
        std::vector<bool> counted;
        const int early = kink > 0 ? kink_rounds : 0;
        for (int round = 0; round < most_rounds; ++round) {
            std::vector<bool> counts;
            for (const Placed* const pair : clipped_) {
                counts.push_back(pair->counts(channel_, pair->read(nodes)));
            }
            if (round > early && !changes(counted, counts)) {
                break;
            }
            Matrix left = left_;
            NodeValues right = right_;
            for (std::size_t i = 0; i < clipped_.size(); ++i) {
                const double share = counts[i] ? 1 : still;
                left.add(*clipped_[i], share);
                // No correction, where that goes beyond the code as well.
                if (counts[i] || clipped_[i]->counts(channel_, 0)) {
                    add_right(*clipped_[i], right, share);
                }
            }
            const double* const at = nodes.data();
            const double doubt = round > 0 && kink > 0 ? smoothness / (kink * kink) : 0;
            left.add_smoothness(
                fading * smoothness * 32 / (size_ - 1), [&](std::size_t node, std::size_t along) {
                    const double bend = at[node] - 2 * at[node + along] + at[node + 2 * along];
                    return smoothness / (1 + doubt * bend * bend);
                });
            left.solve(right, nodes, round >= early ? precision : std::max(precision, on_the_way));
            counted = std::move(counts);
        }
    }

  private:
    void add_right(const Placed& pair, NodeValues& right, double share = 1) const {
        for (std::size_t i = 0; i < pair.node.size(); ++i) {
            right[pair.node[i]] += share * pair.weight * pair.share[i] * pair.after[channel_];
        }
    }
    static bool changes(const std::vector<bool>& was, const std::vector<bool>& is) {
        std::size_t changed = 0;
        for (std::size_t i = 0; i < is.size(); ++i) {
            changed += was[i] != is[i] ? 1 : 0;
        }
        return changed > is.size() / few;
    }

    int size_;
    std::size_t channel_;
    Matrix left_;
    NodeValues right_;
    std::vector<const Placed*> clipped_;
};

} // namespace

ResidualLattice residual_lattice(std::span<const ColorPair> pairs, int size,
                                 const ResidualSettings& settings) {
    check_cube_size(size);
    std::vector<int> sizes{size};
    while (settings.start.empty() && sizes.back() > 2 * coarsest) {
        sizes.push_back((sizes.back() + 1) / 2);
    }
    Channels nodes;
    int start_size = 0;
    ResidualLattice out;
    for (auto level = sizes.rbegin(); level != sizes.rend(); ++level) {
        std::vector<Placed> placed;
        for (const ColorPair& pair : pairs) {
            placed.emplace_back(pair, *level);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            nodes[c] = start_size ? carried_over(nodes[c], start_size, *level) : NodeValues(*level);
            for (std::size_t k = 0; k < settings.start.size(); ++k) {
                nodes[c][k] = settings.start[k][c];
            }
        }
        tbb::parallel_for(std::size_t{0}, std::size_t{3}, [&](std::size_t c) {
            // Kinks are sharp on the finest lattice only.
            ChannelFit(placed, *level, c)
                .run(settings.smoothness[c] * (*level - 1) / 32, *level == size ? settings.kink : 0,
                     settings.precision, nodes[c]);
        });
        start_size = *level;
        if (*level == size) {
            const auto n = static_cast<std::size_t>(size);
            out.support.resize(n * n * n);
            for (const Placed& pair : placed) {
                for (std::size_t i = 0; i < pair.node.size(); ++i) {
                    out.support[pair.node[i]] += pair.weight * pair.share[i] * pair.share[i];
                }
            }
        }
    }
    for (std::size_t k = 0; k < out.support.size(); ++k) {
        out.nodes.push_back({nodes[0][k], nodes[1][k], nodes[2][k]});
    }
    return out;
}

} // namespace lutlib
