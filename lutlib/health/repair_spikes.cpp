// Single nodes that stand out of their neighbours, inside the lattice and on its faces, edges and
// corners.
#include "lutlib/health/axis.h"
#include "lutlib/health/parts.h"
#include "lutlib/health/repair_parts.h"
#include "lutlib/nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lutlib::health {
namespace {

using Node = std::array<int, 3>;

// A spike stands out of all lines through it by far more than the lines beside it bend.
constexpr double spike_ratio = 8;
// In units of the look's outputs, or of their range where that is less: 5 codes of 8 bits.
constexpr double least_spike = 0.02;

class Lattice {
  public:
    Lattice(const Lut3D& cube, std::size_t channel) : cube_(cube), channel_(channel) {}

    int last() const { return cube_.size - 1; }
    double value(const Node& n) const {
        return static_cast<double>(cube_.at(n[0], n[1], n[2])[channel_]);
    }
    bool has(const Node& n) const {
        return std::min({n[0], n[1], n[2]}) >= 0 && std::max({n[0], n[1], n[2]}) <= last();
    }

    /// What the line along an axis says of a node: the mean of its neighbours, or at the lattice's
    /// surface the straight line through the two beside it.
    double line(const Node& n, std::size_t axis) const {
        Node a = n, b = n;
        if (n[axis] > 0 && n[axis] < last()) {
            --a[axis];
            ++b[axis];
            return value(a) / 2 + value(b) / 2;
        }
        const int inwards = n[axis] == 0 ? 1 : -1;
        a[axis] += inwards;
        b[axis] += 2 * inwards;
        return 2 * value(a) - value(b);
    }

    /// How far a node lies off that line. A straight line carried on errs by twice as much as the
    /// mean of two neighbours, where the curvature is the same.
    double bend(const Node& n, std::size_t axis) const {
        const bool surface = n[axis] == 0 || n[axis] == last();
        return std::abs(line(n, axis) - value(n)) / (surface ? 2 : 1);
    }

  private:
    const Lut3D& cube_;
    std::size_t channel_;
};

// The largest bend of lines beside a node, none of which runs through it. Diagonally beside too,
// where a kink across all axes alike shows that the node is not alone.
double largest_bend_beside(const Lattice& lattice, const Node& n) {
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < 9; ++k) {
            Node beside = n;
            beside[(axis + 1) % 3] += k % 3 - 1;
            beside[(axis + 2) % 3] += k / 3 - 1;
            if (beside != n && lattice.has(beside)) {
                most = std::max(most, lattice.bend(beside, axis));
            }
        }
        // On its own line, beyond its neighbours.
        for (const int by : {-2, 2}) {
            Node beyond = n;
            beyond[axis] += by;
            const bool is_inner = beyond[axis] > 0 && beyond[axis] < lattice.last();
            if (is_inner) {
                most = std::max(most, lattice.bend(beyond, axis));
            }
        }
    }
    return most;
}

/// Of a node, what the lines through it say in the middle, and how far it lies beyond them all:
/// above 0 where it is larger than each, below where smaller.
struct Standing {
    std::array<double, 3> lines; ///< rising
    double beyond = 0;
};

Standing standing_of(const Lattice& lattice, const Node& n) {
    Standing out{{lattice.line(n, 0), lattice.line(n, 1), lattice.line(n, 2)}};
    std::sort(out.lines.begin(), out.lines.end());
    const double own = lattice.value(n);
    out.beyond = own > out.lines[2]   ? own - out.lines[2]
                 : own < out.lines[0] ? own - out.lines[0]
                                      : 0;
    return out;
}

bool is_spike(const Lattice& lattice, const Node& n, const Standing& at, double range) {
    const bool on_surface =
        std::min({n[0], n[1], n[2]}) == 0 || std::max({n[0], n[1], n[2]}) == lattice.last();
    const double out = std::abs(at.beyond);
    const double scale =
        std::min(range, std::max({1.0, std::abs(at.lines[0]), std::abs(at.lines[2])}));
    return out > least_spike * scale &&
           out / (on_surface ? 2 : 1) > spike_ratio * largest_bend_beside(lattice, n);
}

struct Spike {
    std::size_t index, channel;
    double value;  ///< without it
    double beyond; ///< as Standing
};

std::vector<Spike> find_spikes(const Lut& lut) {
    constexpr int least_size = 4; // two neighbours of a surface, and one that is not its own
    std::vector<Spike> found;
    if (!lut.cube || lut.cube->size < least_size) {
        return found;
    }
    const Lut3D& cube = *lut.cube;
    const OutputRange all = finite_range(cube.nodes);
    for (std::size_t c = 0; c < 3; ++c) {
        const Lattice lattice(cube, c);
        for_each_node(cube.size, [&](int r, int g, int b) {
            const Node n{r, g, b};
            const Standing at = standing_of(lattice, n);
            if (at.beyond != 0 && is_spike(lattice, n, at, all.high - all.low)) {
                found.push_back({cube.index(r, g, b), c, at.lines[1], at.beyond});
            }
        });
    }
    return found;
}

// The other channels of the same nodes, where they stand out to the same side by a good part as
// much: a node that is wrong is mostly wrong in all, and one levelled channel of three would tint
// it.
std::vector<Spike> companions(const Lut3D& cube, const std::vector<Spike>& found) {
    constexpr double good_part = 0.25;
    const auto is_found = [&](std::size_t index, std::size_t channel) {
        return std::any_of(found.begin(), found.end(), [&](const Spike& spike) {
            return spike.index == index && spike.channel == channel;
        });
    };
    const auto size = static_cast<std::size_t>(cube.size);
    std::vector<Spike> out;
    for (const Spike& spike : found) {
        const Node n{static_cast<int>(spike.index % size),
                     static_cast<int>(spike.index / size % size),
                     static_cast<int>(spike.index / (size * size))};
        for (std::size_t c = 0; c < 3; ++c) {
            const Standing at = standing_of(Lattice(cube, c), n);
            if (at.beyond / spike.beyond > good_part && !is_found(spike.index, c)) {
                out.push_back({spike.index, c, at.lines[1], at.beyond});
            }
        }
    }
    return out;
}

} // namespace

SpikesExamined examine_spikes(const Lut& lut) {
    SpikesExamined out;
    for (const Spike& spike : find_spikes(lut)) {
        ++out.spikes;
        const double off = std::abs(lut.cube->nodes[spike.index][spike.channel] - spike.value);
        if (off > out.largest_spike.value) {
            const auto n = static_cast<std::size_t>(lut.cube->size);
            const auto nodes = inputs_of_nodes(lut, *lut.cube);
            out.largest_spike = {off,
                                 to_float({nodes[0][spike.index % n], nodes[1][spike.index / n % n],
                                           nodes[2][spike.index / (n * n)]})};
        }
    }
    return out;
}

std::string level_spikes(Lut& lut, const RepairOptions& /*options*/) {
    std::vector<Spike> found = find_spikes(lut);
    if (found.empty()) {
        return "";
    }
    Lut3D& cube = *lut.cube;
    const std::vector<Spike> more = companions(cube, found);
    found.insert(found.end(), more.begin(), more.end());
    // A surface's line carried on may lead out of what the rest of the look gives.
    std::vector<Rgb> rest = cube.nodes;
    for (const Spike& spike : found) {
        rest[spike.index] = rest[spike.index == 0 ? 1 : spike.index - 1];
    }
    const OutputRange range = finite_range(rest);
    for (const Spike& spike : found) {
        cube.nodes[spike.index][spike.channel] =
            static_cast<float>(std::clamp(spike.value, range.low, range.high));
    }
    return "single nodes that stood out are levelled with their neighbours";
}

} // namespace lutlib::health
