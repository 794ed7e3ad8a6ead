// Fold-over, stiffness, clipping and plateaus: one pass over the cells of a cube.
#include "lutlib/health/axis.h"
#include "lutlib/health/jacobian.h"
#include "lutlib/health/parts.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/nodes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

namespace lutlib::health {
namespace {

void raise(Extreme& extreme, double value, const Rgb& in) {
    if (value > extreme.value) {
        extreme = {value, in};
    }
}

double dot(const RgbD& a, const RgbD& b) {
    return a.r * b.r + a.g * b.g + a.b * b.b;
}

double length(const RgbD& v) {
    return std::sqrt(dot(v, v));
}

double sum(const RgbD& c) {
    return c.r + c.g + c.b;
}

RgbD magnitudes(const RgbD& c) {
    return {std::abs(c.r), std::abs(c.g), std::abs(c.b)};
}

// A count and the input where the thing begins: the darkest or the brightest of all.
struct Region {
    std::size_t cells = 0;
    Rgb in;

    void add(const Rgb& at, bool darkest) {
        if (cells == 0 || (darkest ? sum(to_double(at)) < sum(to_double(in))
                                   : sum(to_double(at)) > sum(to_double(in)))) {
            in = at;
        }
        ++cells;
    }
    void add(const Region& other, bool darkest) {
        if (other.cells > 0) {
            const std::size_t total = cells + other.cells;
            add(other.in, darkest);
            cells = total;
        }
    }
};

struct Sums {
    std::size_t cells = 0, tetrahedra = 0, flat = 0;
    std::array<std::size_t, 2> signed_count{}; ///< negative, positive
    std::array<double, 2> signed_volume{};
    std::array<Extreme, 2> deepest{};
    Extreme gain, condition, channel_gain;
    std::vector<double> gains, conditions; ///< of the sampled tetrahedra
    std::array<Region, 3> low, high;
    Region plateau;

    void join(const Sums& right) {
        cells += right.cells;
        tetrahedra += right.tetrahedra;
        flat += right.flat;
        for (std::size_t s = 0; s < 2; ++s) {
            signed_count[s] += right.signed_count[s];
            signed_volume[s] += right.signed_volume[s];
            raise(deepest[s], right.deepest[s].value, right.deepest[s].in);
        }
        raise(gain, right.gain.value, right.gain.in);
        raise(condition, right.condition.value, right.condition.in);
        raise(channel_gain, right.channel_gain.value, right.channel_gain.in);
        gains.insert(gains.end(), right.gains.begin(), right.gains.end());
        conditions.insert(conditions.end(), right.conditions.begin(), right.conditions.end());
        for (std::size_t c = 0; c < 3; ++c) {
            low[c].add(right.low[c], false);
            high[c].add(right.high[c], true);
        }
        plateau.add(right.plateau, true);
    }
};

// The smallest that at least this share does not exceed.
double percentile(std::vector<double>& values, double part) {
    if (values.empty()) {
        return 0;
    }
    const auto rank =
        static_cast<std::size_t>(std::ceil(part * static_cast<double>(values.size())));
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

class CellPass {
  public:
    static constexpr std::size_t most_kept = 40000; // cells, some more than 33^3

    CellPass(const Lut& lut, const Lut3D& cube, double rounding)
        : cube_(cube), rounding_(rounding),
          stride_(cube.nodes.size() > most_kept ? (cube.nodes.size() / most_kept) | 1U : 1),
          axes_(cells_of_axes(lut, cube.size, cube.domain)) {
        constexpr float inf = std::numeric_limits<float>::infinity();
        lowest_ = {inf, inf, inf};
        highest_ = {-inf, -inf, -inf};
        for (const Rgb& node : cube.nodes) {
            for (std::size_t c = 0; c < 3 && finite(node); ++c) {
                lowest_[c] = std::min(lowest_[c], node[c]);
                highest_[c] = std::max(highest_[c], node[c]);
            }
        }
    }

    void slab(int b, Sums& out) const {
        const int last = cube_.size - 1;
        for (int g = 0; g < last; ++g) {
            for (int r = 0; r < last; ++r) {
                const std::array<AxisCell, 3> at{axis(0, r), axis(1, g), axis(2, b)};
                if (at[0].reached && at[1].reached && at[2].reached) {
                    cell(r, g, b, at, out);
                }
            }
        }
    }

  private:
    const AxisCell& axis(std::size_t c, int i) const {
        return axes_[c][static_cast<std::size_t>(i)];
    }

    void cell(int r, int g, int b, const std::array<AxisCell, 3>& at, Sums& out) const {
        std::array<RgbD, 8> corner;
        const Rgb* const first = &cube_.at(r, g, b);
        const auto n = static_cast<std::size_t>(cube_.size);
        Rgb low = *first, high = low;
        for (std::size_t k = 0; k < 8; ++k) {
            const Rgb& node = first[(k & 1) + n * ((k >> 1 & 1) + n * (k >> 2))];
            if (!finite(node)) {
                return;
            }
            corner[k] = to_double(node);
            low = {std::min(low.r, node.r), std::min(low.g, node.g), std::min(low.b, node.b)};
            high = {std::max(high.r, node.r), std::max(high.g, node.g), std::max(high.b, node.b)};
        }
        const Rgb in = to_float({at[0].input, at[1].input, at[2].input});
        ++out.cells;
        flatness(low, high, in, out);
        const double volume = at[0].width * at[1].width * at[2].width / 6;
        const bool sampled = cube_.index(r, g, b) % stride_ == 0;
        for (const Walk& walk : tetrahedron_walks) {
            Jacobian edges;
            std::size_t k = 0;
            for (const std::size_t c : walk) {
                const std::size_t next = k | (std::size_t{1} << c);
                edges[c] = corner[next] - corner[k];
                k = next;
            }
            tetrahedron(edges, at, in, volume, sampled, out);
        }
    }

    void flatness(const Rgb& low, const Rgb& high, const Rgb& in, Sums& out) const {
        bool plateau = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double height = static_cast<double>(high[c]) - static_cast<double>(low[c]);
            if (height > tolerance(low[c], high[c])) {
                continue;
            }
            const bool varies = lowest_[c] < highest_[c];
            if (varies && low[c] == lowest_[c]) {
                out.low[c].add(in, false);
            } else if (varies && high[c] == highest_[c]) {
                out.high[c].add(in, true);
            } else {
                plateau = true;
            }
        }
        if (plateau) {
            out.plateau.add(in, true);
        }
    }

    void tetrahedron(const Jacobian& edges, const std::array<AxisCell, 3>& at, const Rgb& in,
                     double volume, bool sampled, Sums& out) const {
        ++out.tetrahedra;
        Jacobian slopes;
        double channel = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            slopes[c] = (at[c].slope * (cube_.size - 1)) * edges[c];
            channel = std::max(channel, largest_magnitude(slopes[c]));
        }
        raise(out.channel_gain, channel, in);
        const double x = length(edges[0]), y = length(edges[1]), z = length(edges[2]);
        const double det = determinant(edges);
        // What two independent roundings, both twice their usual size, make of an edge.
        const double shake = 1.6 * tolerance(static_cast<float>(std::max(std::max(x, y), z)));
        const bool flat = !(std::abs(det) > shake * (x * y + y * z + z * x)) ||
                          !(at[0].slope * at[1].slope * at[2].slope > 0);
        raise_singular(slopes, flat, in, sampled, out);
        if (flat) {
            ++out.flat;
            return;
        }
        const std::size_t sign = det > 0 ? 1 : 0;
        ++out.signed_count[sign];
        out.signed_volume[sign] += volume;
        raise(out.deepest[sign], std::abs(determinant(slopes)), in);
    }

    // The singular values only where their bounds leave a new largest possible:
    // s1^2 <= the largest sum of a column times that of a row, which is sharp for channels that do
    // not mix, and s1 / s3 = s1 * (s1 s2) / |det| <= |J| * |cofactors| / |det|.
    static void raise_singular(const Jacobian& j, bool flat, const Rgb& in, bool sampled,
                               Sums& out) {
        const double square = dot(j[0], j[0]) + dot(j[1], j[1]) + dot(j[2], j[2]);
        const double det = std::abs(determinant(j));
        // |cofactors| <= |J|^2 / sqrt(3)
        const bool ill = !flat && square * std::sqrt(square / 3) > out.condition.value * det;
        const RgbD a = magnitudes(j[0]), b = magnitudes(j[1]), c = magnitudes(j[2]);
        const RgbD rows = a + b + c;
        const double bound = std::max(std::max(sum(a), sum(b)), sum(c)) * largest_magnitude(rows);
        if (!sampled && !ill && bound <= out.gain.value * out.gain.value) {
            return;
        }
        const SingularValues s = singular_values(j);
        raise(out.gain, s.largest, in);
        if (!flat) {
            raise(out.condition, s.largest / s.smallest, in);
        }
        if (sampled) {
            out.gains.push_back(s.largest);
            if (!flat) {
                out.conditions.push_back(s.largest / s.smallest);
            }
        }
    }

    double tolerance(float a, float b = 0) const {
        const double size = std::max(std::abs(a), std::abs(b));
        return std::max(rounding_, size * std::numeric_limits<float>::epsilon());
    }

    const Lut3D& cube_;
    double rounding_;
    std::size_t stride_; ///< between the cells whose singular values are kept
    std::array<AxisCells, 3> axes_;
    Rgb lowest_, highest_;
};

RgbD input_of(const std::array<std::vector<double>, 3>& inputs, const std::array<int, 3>& node) {
    return {inputs[0][static_cast<std::size_t>(node[0])],
            inputs[1][static_cast<std::size_t>(node[1])],
            inputs[2][static_cast<std::size_t>(node[2])]};
}

// The largest along any axis, where both cells beside a node are reached.
Extreme largest_second_difference(const Lut& lut, const Lut3D& cube) {
    const auto axes = cells_of_axes(lut, cube.size, cube.domain);
    const auto inputs = inputs_of_nodes(lut, cube);
    const auto reached = [&](std::size_t c, int i) {
        return i >= 0 && i < cube.size - 1 && axes[c][static_cast<std::size_t>(i)].reached;
    };
    const std::array<std::ptrdiff_t, 3> step{1, cube.size,
                                             static_cast<std::ptrdiff_t>(cube.size) * cube.size};
    Extreme out;
    for_each_node(cube.size, [&](int r, int g, int b) {
        const std::array<int, 3> at{r, g, b};
        const Rgb* const node = &cube.at(r, g, b);
        for (std::size_t c = 0; c < 3; ++c) {
            if (!reached(c, at[c] - 1) || !reached(c, at[c])) {
                continue;
            }
            const RgbD d =
                to_double(node[-step[c]]) - 2 * to_double(*node) + to_double(node[step[c]]);
            for (std::size_t k = 0; k < 3; ++k) {
                if (std::abs(d[k]) > out.value) {
                    out = {std::abs(d[k]), to_float(input_of(inputs, at))};
                }
            }
        }
    });
    return out;
}

} // namespace

CellsExamined examine_cells(const Lut& lut, const Lut3D& cube, double rounding) {
    const CellPass pass(lut, cube, rounding);
    Sums sums = tbb::parallel_deterministic_reduce(
        tbb::blocked_range<int>(0, cube.size - 1, 1), Sums{},
        [&](const tbb::blocked_range<int>& range, Sums partial) {
            for (int b = range.begin(); b < range.end(); ++b) {
                pass.slab(b, partial);
            }
            return partial;
        },
        [](Sums left, const Sums& right) {
            left.join(right);
            return left;
        });
    CellsExamined out;
    CellHealth& cells = out.cells;
    cells.tetrahedra = sums.tetrahedra;
    cells.flat = sums.flat;
    cells.mirrored = sums.signed_count[0] > sums.signed_count[1];
    const std::size_t main = cells.mirrored ? 0 : 1;
    cells.folded = sums.signed_count[1 - main];
    cells.deepest_fold = sums.deepest[1 - main];
    cells.invertible = sums.signed_volume[main];
    cells.gain = sums.gain;
    cells.condition = sums.condition;
    cells.gain_spread = {percentile(sums.gains, 0.5), percentile(sums.gains, 0.99)};
    cells.condition_spread = {percentile(sums.conditions, 0.5), percentile(sums.conditions, 0.99)};
    cells.banding_channel = sums.channel_gain;
    const auto region = [&](const Region& r) { return Extreme{share(r.cells, sums.cells), r.in}; };
    for (std::size_t c = 0; c < 3; ++c) {
        out.table.clipped_low[c] = region(sums.low[c]);
        out.table.clipped_high[c] = region(sums.high[c]);
    }
    out.table.plateau = region(sums.plateau);
    out.table.second_difference = largest_second_difference(lut, cube);
    return out;
}

} // namespace lutlib::health
