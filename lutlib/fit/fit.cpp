#include "lutlib/fit/fit.h"

#include "lutlib/fit/fit_round.h"
#include "lutlib/metrics/samples.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// Codes so fine that plain rounding loses nothing.
constexpr int fine_bits = 16;

// Larger values pull towards the point samples; nodes are well determined by their cells' samples,
// so a little is enough to settle the ends of the domain.
constexpr double ridge = 1e-3;
constexpr double solver_tolerance = 1e-5;
constexpr int solver_iterations = 60;

// A fit must be better by more than the noise of the colours it is checked on.
constexpr double least_gain = 0.01;

// More samples a cell where cells are few: 227,000 colours at 16 nodes, 275,000 at 33.
int samples_per_step(int size) {
    return size <= 17 ? 4 : size <= 25 ? 3 : 2;
}

// Thirty in each cell of a small lattice; of more than 16 nodes, fewer.
int colours_to_judge_by(int size) {
    const int cells = (size - 1) * (size - 1) * (size - 1);
    return std::clamp(30 * cells, 2000, 100000);
}

// The samples of one channel: inputs, their places, and the share of the domain around each.
struct AxisSamples {
    std::vector<double> input, place, share;
};

// The input whose place is `wanted`, by bisection, which needs nothing but that places do not fall.
double input_at(const LatticeReader& reader, std::size_t channel, double wanted) {
    double low = reader.domain.min[channel], high = reader.domain.max[channel];
    for (int i = 0; i < 50; ++i) {
        const double middle = low + (high - low) / 2;
        (reader.place(middle, channel) < wanted ? low : high) = middle;
    }
    return low + (high - low) / 2;
}

AxisSamples axis_samples(const LatticeReader& reader, std::size_t channel) {
    const int steps = samples_per_step(reader.size);
    const double min = reader.domain.min[channel], max = reader.domain.max[channel];
    AxisSamples out;
    const int last = steps * (reader.size - 1);
    for (int i = 0; i <= last; ++i) {
        const double x = i == 0      ? min
                         : i == last ? max
                                     : input_at(reader, channel, static_cast<double>(i) / steps);
        out.input.push_back(x);
        out.place.push_back(reader.place(x, channel));
    }
    for (int i = 0; i <= last; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double before = i > 0 ? out.input[k - 1] : min;
        const double after = i < last ? out.input[k + 1] : max;
        out.share.push_back((after - before) / (2 * (max - min)));
    }
    return out;
}

std::vector<RgbD> mapped(const Transform& look, std::vector<RgbD> colours) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, colours.size(), 1024),
        [&](const auto& range) { look(std::span(colours).subspan(range.begin(), range.size())); });
    for (RgbD& c : colours) {
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = std::isnan(c[i]) ? 0 : c[i];
        }
    }
    return colours;
}

std::vector<RgbD> colours_over(const Domain& domain, int lattice_size, const SampleCounts& counts) {
    std::vector<RgbD> out;
    for (const Rgb& c : sample_colors(lattice_size, counts)) {
        RgbD in;
        for (std::size_t i = 0; i < 3; ++i) {
            in[i] = std::lerp(static_cast<double>(domain.min[i]),
                              static_cast<double>(domain.max[i]), static_cast<double>(c[i]));
        }
        out.push_back(in);
    }
    return out;
}

bool within_unit(const std::vector<RgbD>& colours) {
    return std::all_of(colours.begin(), colours.end(), [](RgbD c) { return saturate(c) == c; });
}

// Colours with what the look makes of them, and the nodes from which a reader makes its answer.
struct Exam {
    std::vector<NodeWeights> weights;
    std::vector<RgbD> targets;

    Exam(const Transform& look, const LatticeReader& reader, const SampleCounts& counts) {
        std::vector<RgbD> inputs = colours_over(reader.domain, std::min(reader.size, 33), counts);
        weights.resize(inputs.size());
        std::transform(inputs.begin(), inputs.end(), weights.begin(), [&](RgbD in) {
            return node_weights(
                reader.how, reader.size,
                {reader.place(in.r, 0), reader.place(in.g, 1), reader.place(in.b, 2)});
        });
        targets = mapped(look, std::move(inputs));
    }

    std::vector<double> errors(const std::vector<RgbD>& nodes, bool held) const {
        std::vector<double> out(targets.size());
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, out.size(), 1024), [&](const auto& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    const NodeWeights& w = weights[i];
                    RgbD sum;
                    for (std::size_t k = 0; k < w.count; ++k) {
                        sum = sum + w.weight[k] * nodes[w.node[k]];
                    }
                    out[i] = largest_magnitude(held ? saturate(sum) - saturate(targets[i])
                                                    : sum - targets[i]);
                }
            });
        return out;
    }
};

std::vector<bool> corners(int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<bool> out(n * n * n);
    for (std::size_t corner = 0; corner < 8; ++corner) {
        out[(n - 1) * ((corner & 1) + n * ((corner >> 1 & 1) + n * (corner >> 2)))] = true;
    }
    return out;
}

// A node with itself and those one step away along any axes.
constexpr std::size_t neighbours = 27;

// Which neighbour of a node another one is.
class NodeGrid {
  public:
    explicit NodeGrid(int size) : size_(static_cast<std::size_t>(size)) {
        place_.reserve(size_ * size_ * size_);
        for (std::size_t k = 0; k < size_ * size_ * size_; ++k) {
            // Differences of these numbers are those of the axes, three to a digit.
            place_.push_back(
                static_cast<int>(k % size_ + 3 * (k / size_ % size_) + 9 * (k / size_ / size_)));
        }
    }

    std::size_t neighbour(std::size_t node, std::size_t other) const {
        return static_cast<std::size_t>(place_[other] - place_[node] +
                                        static_cast<int>(neighbours / 2));
    }

    // From each node's entries with later neighbours, those that they have with it.
    void mirror(std::vector<std::array<double, neighbours>>& rows) const {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            for (std::size_t i = neighbours / 2 + 1; i < neighbours; ++i) {
                if (rows[k][i] != 0) {
                    rows[k + offset(i)][neighbours - 1 - i] = rows[k][i];
                }
            }
        }
    }

    // Leaves a node without entries, its own too.
    void cut_off(std::vector<std::array<double, neighbours>>& rows, std::size_t node) const {
        for (std::size_t i = 0; i < neighbours; ++i) {
            if (rows[node][i] != 0) {
                rows[node + offset(i)][neighbours - 1 - i] = 0;
                rows[node][i] = 0;
            }
        }
    }

    Eigen::SparseMatrix<double, Eigen::RowMajor>
    matrix(const std::vector<std::array<double, neighbours>>& rows) const {
        const auto n = static_cast<Eigen::Index>(rows.size());
        Eigen::SparseMatrix<double, Eigen::RowMajor> out(n, n);
        out.reserve(n * static_cast<Eigen::Index>(neighbours));
        for (Eigen::Index k = 0; k < n; ++k) {
            out.startVec(k);
            for (std::size_t i = 0; i < neighbours; ++i) {
                const double value = rows[static_cast<std::size_t>(k)][i];
                if (value != 0) {
                    out.insertBack(k, k + static_cast<Eigen::Index>(offset(i))) = value;
                }
            }
        }
        out.finalize();
        return out;
    }

  private:
    // From a node to its neighbour, in nodes; modulo 2^64 where it lies before.
    std::size_t offset(std::size_t neighbour) const {
        const auto step = [](std::size_t digit) { return digit % 3 - 1; };
        return step(neighbour) + size_ * (step(neighbour / 3) + size_ * step(neighbour / 9));
    }

    std::size_t size_;
    std::vector<int> place_;
};

} // namespace

// Samples of the look as rows of weights on nodes.
struct LatticeFit::State {
    LatticeReader reader;
    std::vector<RgbD> point, fitted;
    FitSamples samples;
    // One set to find where a fit does harm, another to judge it by.
    std::optional<Exam> rehearsal, exam;
    bool within_unit = false;

    void sample(const Transform& look) {
        const std::array<AxisSamples, 3> axis{axis_samples(reader, 0), axis_samples(reader, 1),
                                              axis_samples(reader, 2)};
        const std::size_t m = axis[0].input.size();
        std::vector<RgbD> inputs;
        inputs.reserve(m * m * m);
        samples.first.push_back(0);
        for (std::size_t b = 0; b < m; ++b) {
            for (std::size_t g = 0; g < m; ++g) {
                for (std::size_t r = 0; r < m; ++r) {
                    inputs.push_back({axis[0].input[r], axis[1].input[g], axis[2].input[b]});
                    const NodeWeights w =
                        node_weights(reader.how, reader.size,
                                     {axis[0].place[r], axis[1].place[g], axis[2].place[b]});
                    for (std::size_t k = 0; k < w.count; ++k) {
                        samples.node.push_back(static_cast<int>(w.node[k]));
                        samples.weight.push_back(static_cast<float>(w.weight[k]));
                    }
                    samples.first.push_back(static_cast<int>(samples.node.size()));
                    samples.share.push_back(
                        static_cast<float>(axis[0].share[r] * axis[1].share[g] * axis[2].share[b]));
                }
            }
        }
        samples.target = mapped(look, std::move(inputs));
        const int count = colours_to_judge_by(reader.size);
        rehearsal.emplace(look, reader, SampleCounts{.random = count});
        exam.emplace(
            look, reader,
            SampleCounts{.neutral = 997, .random = count, .lattice = true, .skipped = count});
        within_unit = lutlib::within_unit(samples.target) && lutlib::within_unit(exam->targets);
    }

    // The normal equations: each node has entries with itself and its neighbours alone.
    void solve() {
        const NodeGrid grid(reader.size);
        std::vector<std::array<double, neighbours>> normal(point.size());
        std::vector<RgbD> pull(point.size());
        for (std::size_t s = 0; s < samples.target.size(); ++s) {
            const auto begin = static_cast<std::size_t>(samples.first[s]);
            const std::size_t count = static_cast<std::size_t>(samples.first[s + 1]) - begin;
            const int* const node = &samples.node[begin];
            const float* const weight = &samples.weight[begin];
            // What the point samples leave over is what the correction of each node must explain.
            const RgbD left = samples.target[s] - samples.read(point, s);
            for (std::size_t i = 0; i < count; ++i) {
                const auto own = static_cast<std::size_t>(node[i]);
                const double w =
                    static_cast<double>(samples.share[s]) * static_cast<double>(weight[i]);
                pull[own] = pull[own] + w * left;
                double* const row = normal[own].data();
                // Nodes rise, and the matrix is symmetric: the other half is filled in below.
                for (std::size_t k = i; k < count; ++k) {
                    row[grid.neighbour(own, static_cast<std::size_t>(node[k]))] +=
                        w * static_cast<double>(weight[k]);
                }
            }
        }
        grid.mirror(normal);
        const std::vector<bool> fixed = corners(reader.size);
        for (std::size_t k = 0; k < point.size(); ++k) {
            if (fixed[k]) {
                pull[k] = {};
                grid.cut_off(normal, k);
            }
            double& own = normal[k][neighbours / 2];
            own = own > 0 ? own * (1 + ridge) : 1;
        }
        const Eigen::SparseMatrix<double, Eigen::RowMajor> matrix = grid.matrix(normal);
        fitted = point;
        tbb::parallel_for(std::size_t{0}, std::size_t{3}, [&](std::size_t c) {
            Eigen::VectorXd right(matrix.rows());
            for (std::size_t k = 0; k < point.size(); ++k) {
                right[static_cast<Eigen::Index>(k)] = pull[k][c];
            }
            Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>,
                                     Eigen::Lower | Eigen::Upper>
                solver;
            solver.setTolerance(solver_tolerance);
            solver.setMaxIterations(solver_iterations);
            solver.compute(matrix);
            const Eigen::VectorXd correction = solver.solve(right);
            for (std::size_t k = 0; k < point.size(); ++k) {
                fitted[k][c] += correction[static_cast<Eigen::Index>(k)];
            }
        });
    }

    // Gives nodes back their plain values wherever a colour of the rehearsal is beyond the cap.
    void repair(std::vector<RgbD>& nodes, const std::vector<RgbD>& plain, bool held,
                double cap) const {
        for (bool changed = true; changed;) {
            changed = false;
            const std::vector<double> now = rehearsal->errors(nodes, held);
            for (std::size_t i = 0; i < now.size(); ++i) {
                if (now[i] <= cap) {
                    continue;
                }
                const NodeWeights& w = rehearsal->weights[i];
                for (std::size_t k = 0; k < w.count; ++k) {
                    changed = changed || !(nodes[w.node[k]] == plain[w.node[k]]);
                    nodes[w.node[k]] = plain[w.node[k]];
                }
            }
        }
    }

    // The candidate, repaired until the exam finds it no worse at its worst than the plain nodes;
    // those, when it is then no better on average.
    FittedLattice judged(std::vector<RgbD> candidate, const std::vector<RgbD>& plain,
                         bool held) const {
        FittedLattice out;
        out.point_sampled = out.result = error_stats(exam->errors(plain, held));
        const std::vector<double> before = rehearsal->errors(plain, held);
        const double worst = *std::max_element(before.begin(), before.end());
        for (const double tightness : {1.0, 0.95, 0.9, 0.8}) {
            repair(candidate, plain, held, tightness * worst);
            const ErrorStats stats = error_stats(exam->errors(candidate, held));
            if (stats.max <= out.point_sampled.max) {
                out.fitted = stats.mean < (1 - least_gain) * out.point_sampled.mean;
                out.result = out.fitted ? stats : out.point_sampled;
                break;
            }
        }
        out.nodes = out.fitted ? std::move(candidate) : plain;
        return out;
    }
};

LatticeFit::LatticeFit(const Transform& look, LatticeReader reader, std::vector<RgbD> point_samples)
    : state_(std::make_unique<State>()) {
    state_->reader = std::move(reader);
    state_->point = std::move(point_samples);
    state_->sample(look);
    state_->solve();
}

LatticeFit::~LatticeFit() = default;
LatticeFit::LatticeFit(LatticeFit&&) noexcept = default;

FittedLattice LatticeFit::exact() const {
    return state_->judged(state_->fitted, state_->point, state_->within_unit);
}

FittedLattice LatticeFit::rounded(CodeDepth depth) const {
    const State& s = *state_;
    const std::vector<RgbD> plain = rounded_to_codes(s.point, depth);
    std::vector<RgbD> nodes = rounded_to_codes(s.fitted, depth);
    if (depth.bits < fine_bits) {
        nodes = descended(s.samples, std::move(nodes), plain, corners(s.reader.size), s.reader.size,
                          depth);
    }
    return s.judged(std::move(nodes), plain, true);
}

LatticeReader reader_of(const Engine& engine, int size) {
    return {size, engine.interpolation, {}, [&engine, size](double in, std::size_t) {
                return engine.place(in, size);
            }};
}

LatticeReader reader_of(const Lut& lut, Interpolation how) {
    LatticeReader out{lut.cube->size, how, lut.domain(), {}};
    const auto shaper = lut.shaper ? std::make_shared<const Lut1D>(*lut.shaper) : nullptr;
    out.place = [shaper, domain = lut.cube->domain, size = out.size](double in, std::size_t c) {
        const double x = shaper ? evaluate_exact(*shaper, {in, in, in})[c] : in;
        const double min = domain.min[c], max = domain.max[c];
        return std::clamp((x - min) / (max - min), 0.0, 1.0) * (size - 1);
    };
    return out;
}

std::vector<RgbD> point_samples(const Transform& look, const LatticeReader& reader) {
    std::array<std::vector<double>, 3> axis;
    for (std::size_t c = 0; c < 3; ++c) {
        for (int i = 0; i < reader.size; ++i) {
            axis[c].push_back(i == 0                 ? reader.domain.min[c]
                              : i == reader.size - 1 ? reader.domain.max[c]
                                                     : input_at(reader, c, i));
        }
    }
    std::vector<RgbD> nodes;
    for (const double b : axis[2]) {
        for (const double g : axis[1]) {
            for (const double r : axis[0]) {
                nodes.push_back({r, g, b});
            }
        }
    }
    return mapped(look, std::move(nodes));
}

} // namespace lutlib
