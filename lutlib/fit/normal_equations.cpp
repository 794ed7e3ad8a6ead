#include "lutlib/fit/normal_equations.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>

namespace lutlib {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Tikhonov regularisation, as a share of each node's own weight. Larger values draw nodes to their
// point samples; their cells' samples determine them well, so a little is enough to settle the ends
// of the domain.
constexpr double regularisation = 1e-3;
constexpr double solver_tolerance = 1e-5;
constexpr int solver_iterations = 60;

// A node with itself and those one step away along any axes, numbered as the digits of base 3:
// the steps along red, green and blue, each plus 1.
constexpr std::size_t neighbours = 27;
constexpr std::size_t itself = neighbours / 2;
constexpr std::size_t opposite(std::size_t neighbour) {
    return neighbours - 1 - neighbour;
}
using Row = std::array<double, neighbours>;

// The symmetric matrix of a lattice's nodes.
class NodeMatrix {
  public:
    explicit NodeMatrix(int size)
        : size_(static_cast<std::ptrdiff_t>(size)),
          rows_(static_cast<std::size_t>(size_ * size_ * size_)) {
        place_.reserve(rows_.size());
        for (std::ptrdiff_t k = 0; k < size_ * size_ * size_; ++k) {
            // The difference of two such numbers is the number of their steps in base 3.
            place_.push_back(
                static_cast<int>(k % size_ + 3 * (k / size_ % size_) + 9 * (k / size_ / size_)));
        }
    }

    // `other` is `node` or a neighbour behind it in the order of nodes; complete() does the rest.
    void add(std::size_t node, std::size_t other, double value) {
        const int steps = place_[other] - place_[node];
        rows_[node][itself + static_cast<std::size_t>(steps)] += value;
    }

    // From each node's entries with later neighbours, those that they have with it.
    void complete() {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            for (std::size_t i = itself + 1; i < neighbours; ++i) {
                if (rows_[k][i] != 0) {
                    rows_[neighbour(k, i)][opposite(i)] = rows_[k][i];
                }
            }
        }
    }

    // Leaves a node without entries, its own too.
    void cut_off(std::size_t node) {
        for (std::size_t i = 0; i < neighbours; ++i) {
            if (rows_[node][i] != 0) {
                rows_[neighbour(node, i)][opposite(i)] = 0;
                rows_[node][i] = 0;
            }
        }
    }

    // Nodes without a sample, and those cut off, get an entry of 1.
    void regularise() {
        for (Row& row : rows_) {
            row[itself] = row[itself] > 0 ? row[itself] * (1 + regularisation) : 1;
        }
    }

    Matrix sparse() const {
        const auto n = static_cast<Eigen::Index>(rows_.size());
        Matrix out(n, n);
        out.reserve(n * static_cast<Eigen::Index>(neighbours));
        for (Eigen::Index k = 0; k < n; ++k) {
            out.startVec(k);
            for (std::size_t i = 0; i < neighbours; ++i) {
                const double value = rows_[static_cast<std::size_t>(k)][i];
                if (value != 0) {
                    out.insertBack(k, static_cast<Eigen::Index>(
                                          neighbour(static_cast<std::size_t>(k), i))) = value;
                }
            }
        }
        out.finalize();
        return out;
    }

  private:
    std::size_t neighbour(std::size_t node, std::size_t number) const {
        const auto step = [](std::size_t digit) {
            return static_cast<std::ptrdiff_t>(digit % 3) - 1;
        };
        const std::ptrdiff_t offset =
            step(number) + size_ * (step(number / 3) + size_ * step(number / 9));
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + offset);
    }

    std::ptrdiff_t size_;
    std::vector<Row> rows_;
    std::vector<int> place_;
};

std::vector<double> solution(const Matrix& matrix, const std::vector<double>& right_side) {
    const Eigen::Map<const Eigen::VectorXd> right(right_side.data(), matrix.rows());
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(solver_tolerance);
    solver.setMaxIterations(solver_iterations);
    solver.compute(matrix);
    const Eigen::VectorXd out = solver.solve(right);
    return {out.begin(), out.end()};
}

// Of a channel's square, what is not the eye's.
constexpr float even_share = 0.3F;

// What the eye sees of a channel's error at each sample, 1 in the mean, beside an even share.
std::vector<float> seen(const FitSamples& samples, std::size_t channel) {
    std::vector<float> out;
    out.reserve(samples.form.size());
    double sum = 0;
    for (std::size_t s = 0; s < samples.form.size(); ++s) {
        out.push_back(samples.form[s].of_channel(channel));
        sum += static_cast<double>(samples.share[s]) * static_cast<double>(out.back());
    }
    const auto scale =
        static_cast<float>(sum > 0 ? (1 - static_cast<double>(even_share)) / sum : 0);
    for (float& weight : out) {
        weight = even_share + scale * weight;
    }
    return out;
}

std::vector<double> fitted_channel(const FitSamples& samples, const std::vector<RgbD>& point,
                                   const std::vector<bool>& fixed, int size, std::size_t channel) {
    NodeMatrix normal(size);
    std::vector<double> right_side(point.size());
    const std::vector<float> weight = seen(samples, channel);
    for (std::size_t s = 0; s < samples.target.size(); ++s) {
        const auto begin = static_cast<std::size_t>(samples.first[s]);
        const auto end = static_cast<std::size_t>(samples.first[s + 1]);
        // What the point samples leave over is what the corrections of the nodes must explain.
        const double residual = samples.target[s][channel] - samples.read(point, s)[channel];
        for (std::size_t i = begin; i < end; ++i) {
            const auto node = static_cast<std::size_t>(samples.node[i]);
            const double w = static_cast<double>(samples.share[s] * weight[s]) *
                             static_cast<double>(samples.weight[i]);
            right_side[node] += w * residual;
            for (std::size_t k = i; k < end; ++k) {
                normal.add(node, static_cast<std::size_t>(samples.node[k]),
                           w * static_cast<double>(samples.weight[k]));
            }
        }
    }
    normal.complete();
    for (std::size_t k = 0; k < point.size(); ++k) {
        if (fixed[k]) {
            right_side[k] = 0;
            normal.cut_off(k);
        }
    }
    normal.regularise();
    return solution(normal.sparse(), right_side);
}

} // namespace

std::vector<RgbD> least_squares(const FitSamples& samples, const std::vector<RgbD>& point,
                                const std::vector<bool>& fixed, int size) {
    std::vector<RgbD> out = point;
    tbb::parallel_for(std::size_t{0}, std::size_t{3}, [&](std::size_t c) {
        const std::vector<double> correction = fitted_channel(samples, point, fixed, size, c);
        for (std::size_t k = 0; k < out.size(); ++k) {
            out[k][c] += correction[k];
        }
    });
    return out;
}

} // namespace lutlib
