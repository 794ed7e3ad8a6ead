#include "lutlib/match/base_look.h"

#include "lutlib/color/luma.h"
#include "lutlib/error.h"
#include "lutlib/rising.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lutlib {
namespace {

constexpr int rounds = 12;
// Of each part, in shares of the pairs' whole weight.
constexpr double curve_bending = 1e-4, curve_slope = 1e-6, gain_bending = 1e-4, to_identity = 1e-5;
// What a step may change a parameter by: it is right for small ones alone.
constexpr double largest_step = 0.3, largest_gain = 3;

// Knots that stand evenly from `low` to `high`.
template <std::size_t count>
struct Knotted {
    double low, high;

    double at(std::size_t i) const {
        return std::lerp(low, high, static_cast<double>(i) / static_cast<double>(count - 1));
    }
    double spacing() const { return (high - low) / static_cast<double>(count - 1); }
    // The knot before a place, and how much of the way to the next one it stands.
    std::pair<std::size_t, double> before(double x) const {
        const double place = std::clamp((x - low) / spacing(), 0.0, static_cast<double>(count - 1));
        const std::size_t i = std::min(static_cast<std::size_t>(place), count - 2);
        return {i, place - static_cast<double>(i)};
    }
};

constexpr std::size_t curve_knots = 49, gain_knots = 6;
constexpr Knotted<curve_knots> along_curve{-0.25, 1.25};
constexpr Knotted<gain_knots> along_luma{0, 1};

constexpr std::size_t parameters = 6 + gain_knots; // of a row of the matrix the first two entries
using Square = Eigen::Matrix<double, static_cast<int>(parameters), static_cast<int>(parameters)>;
using Column = Eigen::Matrix<double, static_cast<int>(parameters), 1>;

Eigen::Index index(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

// Adds the square of the second difference about each inner one of `count` unknowns from `first`.
template <class Matrix>
void add_bending(Matrix& to, std::size_t first, std::size_t count, double weight) {
    constexpr std::array<double, 3> difference{1, -2, 1};
    for (std::size_t at = first; at + 2 < first + count; ++at) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                to(index(at + i), index(at + k)) += weight * difference[i] * difference[k];
            }
        }
    }
}

// What a colour becomes on its way to the curves.
struct Mixed {
    RgbD matrixed, mixed;
    double luma, gain;
};

Mixed mixed(const BaseLook& look, RgbD in) {
    const RgbD matrixed = look.matrix * in;
    const double y = luma(matrixed), gain = look.gain(y);
    const RgbD grey{y, y, y};
    return {matrixed, grey + gain * (matrixed - grey), y, gain};
}

class BaseFit {
  public:
    explicit BaseFit(std::span<const ColorPair> pairs) : pairs_(pairs) {
        for (const ColorPair& pair : pairs) {
            whole_ += pair.weight;
        }
        if (!(whole_ > 0)) {
            throw Error("there are no colours to learn a look from");
        }
        parameters_ << 1, 0, 0, 1, 0, 0, Eigen::Matrix<double, gain_knots, 1>::Ones();
        identity_ = parameters_;
        take_parameters();
    }

    BaseLook run() {
        BaseLook best = look_;
        double least = std::numeric_limits<double>::infinity();
        for (int round = 0; round < rounds; ++round) {
            fit_curves();
            const double off = squares();
            if (off < least) {
                least = off;
                best = look_;
            }
            step();
        }
        return best;
    }

  private:
    void take_parameters() {
        for (std::size_t row = 0; row < 3; ++row) {
            const double r = parameters_(index(2 * row)), g = parameters_(index(2 * row + 1));
            look_.matrix.m[row] = {r, g, 1 - r - g};
        }
        Knots knots;
        for (std::size_t i = 0; i < gain_knots; ++i) {
            knots.push_back({along_luma.at(i), parameters_(index(6 + i))});
        }
        look_.gain = Curve::open(std::move(knots));
    }

    void fit_curves() {
        std::vector<RgbD> in;
        in.reserve(pairs_.size());
        for (const ColorPair& pair : pairs_) {
            in.push_back(mixed(look_, pair.before).mixed);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            look_.curves[c] = fitted_curve(in, c);
        }
    }

    Curve fitted_curve(const std::vector<RgbD>& in, std::size_t c) const {
        constexpr int n = static_cast<int>(curve_knots);
        Eigen::Matrix<double, n, n> square = Eigen::Matrix<double, n, n>::Zero();
        Eigen::Matrix<double, n, 1> right = Eigen::Matrix<double, n, 1>::Zero();
        double x = 0, y = 0, xy = 0;
        for (std::size_t p = 0; p < in.size(); ++p) {
            const double w = pairs_[p].weight, wanted = pairs_[p].after[c];
            const auto [i, share] = along_curve.before(in[p][c]);
            const Eigen::Index k = index(i);
            square(k, k) += w * (1 - share) * (1 - share);
            square(k + 1, k + 1) += w * share * share;
            square(k, k + 1) += w * share * (1 - share);
            right(k) += w * (1 - share) * wanted;
            right(k + 1) += w * share * wanted;
            x += w * in[p][c];
            y += w * wanted;
            xy += w * in[p][c] * wanted;
        }
        const double sense = xy - x * y / whole_ < 0 ? -1 : 1;
        for (Eigen::Index k = 0; k + 1 < n; ++k) {
            square(k + 1, k) = square(k, k + 1);
        }
        add_bending(square, 0, curve_knots, curve_bending * whole_);
        for (Eigen::Index k = 0; k + 1 < n; ++k) {
            const double w = curve_slope * whole_, rise = sense * along_curve.spacing();
            square(k, k) += w;
            square(k + 1, k + 1) += w;
            square(k, k + 1) -= w;
            square(k + 1, k) -= w;
            right(k) -= w * rise;
            right(k + 1) += w * rise;
        }
        const Eigen::Matrix<double, n, 1> solved = square.ldlt().solve(right);
        std::vector<double> values, weights;
        for (Eigen::Index k = 0; k < n; ++k) {
            values.push_back(sense * solved(k));
            weights.push_back(square(k, k));
        }
        values = rising(values, weights);
        Knots knots;
        for (std::size_t k = 0; k < curve_knots; ++k) {
            knots.push_back({along_curve.at(k), sense * values[k]});
        }
        return Curve::open(std::move(knots));
    }

    double squares() const {
        double out = 0;
        for (const ColorPair& pair : pairs_) {
            const RgbD off = look_(pair.before) - pair.after;
            out += pair.weight * (off.r * off.r + off.g * off.g + off.b * off.b);
        }
        return out;
    }

    // How much a curve rises from half a knot before a place to half a knot behind it.
    double slope(std::size_t c, double x) const {
        const double half = along_curve.spacing() / 2;
        return (look_.curves[c](x + half) - look_.curves[c](x - half)) / (2 * half);
    }

    // One of Gauss and Newton, towards what the curves leave over.
    void step() {
        constexpr RgbD luma_weights{luma({1, 0, 0}), luma({0, 1, 0}), luma({0, 0, 1})};
        Square square = Square::Zero();
        Column right = Column::Zero();
        for (const ColorPair& pair : pairs_) {
            const Mixed at = mixed(look_, pair.before);
            const auto [knot, share] = along_luma.before(at.luma);
            for (std::size_t c = 0; c < 3; ++c) {
                const double rise = slope(c, at.mixed[c]);
                Column row = Column::Zero();
                for (std::size_t from = 0; from < 3; ++from) {
                    const double part =
                        luma_weights[from] * (1 - at.gain) + (from == c ? at.gain : 0);
                    row(index(2 * from)) = rise * part * (pair.before.r - pair.before.b);
                    row(index(2 * from + 1)) = rise * part * (pair.before.g - pair.before.b);
                }
                const double chroma = rise * (at.matrixed[c] - at.luma);
                row(index(6 + knot)) = (1 - share) * chroma;
                row(index(7 + knot)) = share * chroma;
                square.noalias() += pair.weight * row * row.transpose();
                right += pair.weight * (pair.after[c] - look_.curves[c](at.mixed[c])) * row;
            }
        }
        Square held = Square::Identity() * (to_identity * whole_);
        add_bending(held, 6, gain_knots, gain_bending * whole_);
        right -= held * (parameters_ - identity_);
        const Column change = (square + held).ldlt().solve(right);
        parameters_ += change.cwiseMax(-largest_step).cwiseMin(largest_step);
        parameters_.tail<gain_knots>() =
            parameters_.tail<gain_knots>().cwiseMax(0).cwiseMin(largest_gain);
        take_parameters();
    }

    std::span<const ColorPair> pairs_;
    double whole_ = 0;
    Column parameters_, identity_;
    BaseLook look_;
};

} // namespace

RgbD BaseLook::operator()(RgbD in) const {
    const RgbD to = mixed(*this, in).mixed;
    return {curves[0](to.r), curves[1](to.g), curves[2](to.b)};
}

BaseLook fitted_base(std::span<const ColorPair> pairs) {
    return BaseFit(pairs).run();
}

} // namespace lutlib
