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
// Of the line that a curve begins as.
constexpr double least_slope = 0.1, largest_slope = 4;

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

// The unknowns of a round: the knots of three curves, then the mixing: of each row of the matrix
// the first two entries, and the knots of the gain.
constexpr std::size_t mixing = 3 * curve_knots, mixing_count = 6 + gain_knots;
constexpr std::size_t unknowns = mixing + mixing_count;
using Square = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using MixingColumn = Eigen::Matrix<double, static_cast<int>(mixing_count), 1>;

Eigen::Index index(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

// Adds the square of the second difference about each inner one of `count` unknowns from `first`.
void add_bending(Square& to, std::size_t first, std::size_t count, double weight) {
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
        mixing_ << 1, 0, 0, 1, 0, 0, Eigen::Matrix<double, static_cast<int>(gain_knots), 1>::Ones();
        identity_ = mixing_;
        take_mixing();
        for (std::size_t c = 0; c < 3; ++c) {
            begin_straight(c);
        }
    }

    BaseLook run() {
        BaseLook best = look_;
        double least = std::numeric_limits<double>::infinity();
        for (int round = 0; round < rounds; ++round) {
            step();
            const double off = squares();
            if (off < least) {
                least = off;
                best = look_;
            }
        }
        return best;
    }

  private:
    void take_mixing() {
        for (std::size_t row = 0; row < 3; ++row) {
            const double r = mixing_(index(2 * row)), g = mixing_(index(2 * row + 1));
            look_.matrix.m[row] = {r, g, 1 - r - g};
        }
        Knots knots;
        for (std::size_t i = 0; i < gain_knots; ++i) {
            knots.push_back({along_luma.at(i), mixing_(index(6 + i))});
        }
        look_.gain = Curve::open(std::move(knots));
    }

    // A line, which has a slope for the first step.
    void begin_straight(std::size_t c) {
        double x = 0, y = 0, xx = 0, xy = 0;
        for (const ColorPair& pair : pairs_) {
            const double w = pair.weight / whole_, in = pair.before[c], out = pair.after[c];
            x += w * in;
            y += w * out;
            xx += w * in * in;
            xy += w * in * out;
        }
        const double spread = xx - x * x, both = xy - x * y;
        sense_[c] = both < 0 ? -1 : 1;
        const double slope = spread > 0 ? std::abs(both) / spread : 1;
        const double rise = sense_[c] * std::clamp(slope, least_slope, largest_slope);
        look_.curves[c] = Curve::open({{along_curve.low, y + rise * (along_curve.low - x)},
                                       {along_curve.high, y + rise * (along_curve.high - x)}});
    }

    double squares() const {
        double out = 0;
        for (const ColorPair& pair : pairs_) {
            const RgbD off = off_by(pair.after, look_(pair.before), pair.clipped);
            out += pair.weight * (off.r * off.r + off.g * off.g + off.b * off.b);
        }
        return out;
    }

    // How much a curve rises from half a knot before a place to half a knot behind it.
    double slope(std::size_t c, double x) const {
        const double half = along_curve.spacing() / 2;
        return (look_.curves[c](x + half) - look_.curves[c](x - half)) / (2 * half);
    }

    // What a channel's input to its curve changes by with the mixing.
    MixingColumn mixing_row(const ColorPair& pair, const Mixed& at, std::size_t c) const {
        constexpr RgbD luma_weights{luma({1, 0, 0}), luma({0, 1, 0}), luma({0, 0, 1})};
        MixingColumn row = MixingColumn::Zero();
        for (std::size_t from = 0; from < 3; ++from) {
            const double part = luma_weights[from] * (1 - at.gain) + (from == c ? at.gain : 0);
            row(index(2 * from)) = part * (pair.before.r - pair.before.b);
            row(index(2 * from + 1)) = part * (pair.before.g - pair.before.b);
        }
        const auto [knot, share] = along_luma.before(at.luma);
        row(index(6 + knot)) = (1 - share) * (at.matrixed[c] - at.luma);
        row(index(7 + knot)) = share * (at.matrixed[c] - at.luma);
        return row;
    }

    // The upper triangle and the right side: of the knots as they shall be, and of what is to be
    // added to the mixing.
    void add_pairs(Square& square, Column& right) const {
        for (const ColorPair& pair : pairs_) {
            const Mixed at = mixed(look_, pair.before);
            for (std::size_t c = 0; c < 3; ++c) {
                const double w = pair.weight, in = at.mixed[c];
                if (pair.clipped[c] * (look_.curves[c](in) - pair.after[c]) > 0) {
                    continue;
                }
                const MixingColumn row = slope(c, in) * mixing_row(pair, at, c);
                const auto [knot, share] = along_curve.before(in);
                const Eigen::Index k = index(c * curve_knots + knot);
                square(k, k) += w * (1 - share) * (1 - share);
                square(k + 1, k + 1) += w * share * share;
                square(k, k + 1) += w * share * (1 - share);
                square.row(k).tail<mixing_count>() += w * (1 - share) * row.transpose();
                square.row(k + 1).tail<mixing_count>() += w * share * row.transpose();
                square.bottomRightCorner<mixing_count, mixing_count>() += w * row * row.transpose();
                right(k) += w * (1 - share) * pair.after[c];
                right(k + 1) += w * share * pair.after[c];
                right.tail<mixing_count>() += w * pair.after[c] * row;
            }
        }
    }

    void add_smoothness(Square& square, Column& right) const {
        for (std::size_t c = 0; c < 3; ++c) {
            add_bending(square, c * curve_knots, curve_knots, curve_bending * whole_);
            const double w = curve_slope * whole_, rise = sense_[c] * along_curve.spacing();
            for (std::size_t i = 0; i + 1 < curve_knots; ++i) {
                const Eigen::Index k = index(c * curve_knots + i);
                square(k, k) += w;
                square(k + 1, k + 1) += w;
                square(k, k + 1) -= w;
                square(k + 1, k) -= w;
                right(k) -= w * rise;
                right(k + 1) += w * rise;
            }
        }
        Square held = Square::Identity(mixing_count, mixing_count) * (to_identity * whole_);
        add_bending(held, 6, gain_knots, gain_bending * whole_);
        square.bottomRightCorner<mixing_count, mixing_count>() += held;
        right.tail<mixing_count>() -= held * (mixing_ - identity_);
    }

    // One of Gauss and Newton, of everything at once.
    void step() {
        Square square = Square::Zero(index(unknowns), index(unknowns));
        Column right = Column::Zero(index(unknowns));
        add_pairs(square, right);
        square = Square(square.selfadjointView<Eigen::Upper>());
        add_smoothness(square, right);
        const Column solved = square.ldlt().solve(right);
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<double> values, weights;
            for (std::size_t i = 0; i < curve_knots; ++i) {
                const Eigen::Index k = index(c * curve_knots + i);
                values.push_back(sense_[c] * solved(k));
                weights.push_back(square(k, k));
            }
            values = rising(values, weights);
            Knots knots;
            for (std::size_t i = 0; i < curve_knots; ++i) {
                knots.push_back({along_curve.at(i), sense_[c] * values[i]});
            }
            look_.curves[c] = Curve::open(std::move(knots));
        }
        const MixingColumn change = solved.tail<mixing_count>();
        mixing_ += change.cwiseMax(-largest_step).cwiseMin(largest_step);
        mixing_.tail<gain_knots>() = mixing_.tail<gain_knots>().cwiseMax(0).cwiseMin(largest_gain);
        take_mixing();
    }

    std::span<const ColorPair> pairs_;
    double whole_ = 0;
    MixingColumn mixing_, identity_;
    std::array<double, 3> sense_{};
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
