#include "lutlib/match/match_look.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/match/greys.h"
#include "lutlib/match/residual_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// Bins are half a cell wide: what bends within one cannot be told by the lattice either.
constexpr int bins_a_cell = 2, most_bins = 128;
// Of a channel that was rounded to a step of 1; smoothness is said for the noise of 8 bits.
constexpr double rounding_noise = 1 / 3.4641016151377544, usual_noise = rounding_noise / 255;
// Pixels of one colour that count: more of them tell no better what a lattice cannot hold anyway.
constexpr double pixels_that_count = 30;
// What tells colours that stray; then of these, from the stiffest on, what suits the channel, as a
// lattice of half as many nodes shows it.
constexpr double stiff = 10;
constexpr std::array<double, 3> smoothnesses{10, 1, 0.1};
// Of what a stiffer one misses: so much is chance.
constexpr double worth_bending = 1.005;
constexpr double noisy = 2 * usual_noise;
// Of the colours, those that the others foretell to find it out.
constexpr std::size_t foretold = 4;
// Pixels, and colours, are doubted from so many deviations on, and never within so many codes.
constexpr double pixel_doubt = 6, color_doubt = 6, never_doubted = 4 / 255.0;
// To what share lattices are solved.
constexpr double rough = 1e-3, fine = 2e-4;

double squared(double x) {
    return x * x;
}

// The weights of means of so many pixels, of which each has the noise, and the lattice a misfit.
std::vector<ColorPair> weighed(std::vector<ColorPair> means, double noise,
                               const std::vector<double>& trust) {
    for (std::size_t i = 0; i < means.size(); ++i) {
        const double pixels = means[i].weight, clean = squared(usual_noise);
        means[i].weight =
            trust[i] * pixels * clean / (squared(noise) + pixels * clean / pixels_that_count);
    }
    return means;
}

// In fewer bins, which is enough for what has few parameters.
std::vector<ColorPair> coarsened(std::span<const ColorPair> pairs, int side) {
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const RgbD place = saturate(pairs[i].before) * static_cast<double>(side - 1);
        std::size_t key = 0;
        for (const std::int8_t clipped : pairs[i].clipped) {
            key = 3 * key + static_cast<std::size_t>(clipped + 1);
        }
        for (const double x : {place.b, place.g, place.r}) {
            key = key * static_cast<std::size_t>(side) + static_cast<std::size_t>(x + 0.5);
        }
        order.emplace_back(key, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<ColorPair> out;
    for (std::size_t i = 0; i < order.size();) {
        ColorPair sum{{}, {}, 0, pairs[order[i].second].clipped};
        for (const std::size_t key = order[i].first; i < order.size() && order[i].first == key;
             ++i) {
            const ColorPair& pair = pairs[order[i].second];
            sum = {sum.before + pair.weight * pair.before, sum.after + pair.weight * pair.after,
                   sum.weight + pair.weight, sum.clipped};
        }
        if (sum.weight > 0) {
            out.push_back(
                {1 / sum.weight * sum.before, 1 / sum.weight * sum.after, sum.weight, sum.clipped});
        }
    }
    return out;
}

Lut3D of_size(const Lut3D& cube, int size) {
    if (cube.size == size) {
        return cube;
    }
    Lut3D out = identity_cube(size);
    for (Rgb& node : out.nodes) {
        node = to_float(evaluate_exact(cube, to_double(node), Interpolation::tetrahedral));
    }
    return out;
}

class Learning {
  public:
    Learning(std::vector<PixelPair> pixels, const MatchSettings& settings)
        : bins_(std::move(pixels), std::min(bins_a_cell * (settings.size - 1), most_bins),
                settings.bits > 0, settings.size),
          size_(settings.size),
          least_noise_(settings.bits ? rounding_noise / ((1 << settings.bits) - 1) : 0),
          noise_(usual_noise), trust_(bins_.size(), 1) {}

    Match run(const Match* start) {
        if (start) {
            lut_.cube = of_size(start->cube, size_);
            out_.smoothness = start->smoothness;
        } else {
            fit(bins_.means(), {stiff, stiff, stiff}, 0, rough);
            const std::vector<ColorPair> means = without_strays();
            trust(means);
            choose_smoothness(means);
            lut_.cube.reset();
            fit(means, out_.smoothness, kink(), rough);
        }
        const std::vector<ColorPair> means = without_strays();
        if (start) {
            trust(means);
        }
        fit(means, out_.smoothness, kink(), fine);
        out_.noise = noise_;
        // One pixel's weight, so that support counts pixels whatever their noise.
        const double of_one =
            squared(usual_noise) / (squared(noise_) + squared(usual_noise) / pixels_that_count);
        for (double& support : out_.support) {
            support /= of_one;
        }
        out_.greys_fall = make_greys_rise(out_.cube, out_.support, noise_);
        return std::move(out_);
    }

  private:
    // Where pixels are noisy so are bends, and none of them can be told from a kink.
    double kink() const { return noise_ < noisy ? usual_noise : 0; }
    Transform look() const { return Transform::of(lut_); }

    std::vector<ColorPair> without_strays() {
        noise_ = std::max(bins_.noise(look()), least_noise_);
        const double own = std::sqrt(std::max(0.0, squared(noise_) - squared(least_noise_)));
        std::vector<ColorPair> out = bins_.robust_means(
            look(), std::max(pixel_doubt * noise_, never_doubted), {least_noise_, own});
        // Noise about an end of the codes falls on one side of it, and pulls only from there.
        for (ColorPair& pair : out) {
            pair.clipped = noise_ < noisy ? pair.clipped : Clipped{};
        }
        return out;
    }

    // What the base leaves over, as the lattice shows it: straight between its nodes.
    std::vector<ColorPair> residuals(const std::vector<ColorPair>& means) {
        std::vector<ColorPair> pairs = weighed(means, noise_, trust_);
        out_.base = fitted_base(coarsened(pairs, size_));
        for (std::size_t k = 0; k < base_.nodes.size(); ++k) {
            base_.nodes[k] = to_float(out_.base(to_double(identity_.nodes[k])));
        }
        for (ColorPair& pair : pairs) {
            pair.after =
                pair.after - evaluate_exact(base_, pair.before, Interpolation::tetrahedral);
        }
        return pairs;
    }

    // By how well colours foretell others, of each channel.
    void choose_smoothness(const std::vector<ColorPair>& means) {
        std::vector<ColorPair> known, unknown;
        std::size_t i = 0;
        for (const ColorPair& pair : residuals(means)) {
            (i++ % foretold == 0 ? unknown : known).push_back(pair);
        }
        const int size = (size_ + 1) / 2;
        RgbD least;
        for (const double smoothness : smoothnesses) {
            const ResidualLattice lattice = residual_lattice(
                known, size, {{smoothness, smoothness, smoothness}, kink(), rough});
            Lut3D cube = identity_cube(size);
            std::transform(lattice.nodes.begin(), lattice.nodes.end(), cube.nodes.begin(),
                           to_float);
            RgbD off;
            for (const ColorPair& pair : unknown) {
                const RgbD found = evaluate_exact(cube, pair.before, Interpolation::tetrahedral);
                const RgbD by = off_by(pair.after, found, pair.clipped);
                for (std::size_t c = 0; c < 3; ++c) {
                    off[c] += pair.weight * std::min(squared(by[c]), squared(never_doubted));
                }
            }
            for (std::size_t c = 0; c < 3; ++c) {
                if (smoothness == smoothnesses.front() || off[c] < worth_bending * least[c]) {
                    least[c] =
                        smoothness == smoothnesses.front() ? off[c] : std::min(least[c], off[c]);
                    out_.smoothness[c] = smoothness;
                }
            }
        }
    }

    // From the look so far, once there is one.
    void fit(const std::vector<ColorPair>& means, RgbD smoothness, double kink, double precision) {
        const std::vector<ColorPair> pairs = residuals(means);
        std::vector<RgbD> start;
        for (std::size_t k = 0; lut_.cube && k < lut_.cube->nodes.size(); ++k) {
            start.push_back(to_double(lut_.cube->nodes[k]) - to_double(base_.nodes[k]));
        }
        ResidualLattice residual =
            residual_lattice(pairs, size_, {smoothness, kink, precision, start});
        out_.support = std::move(residual.support);
        out_.cube = base_;
        for (std::size_t k = 0; k < out_.cube.nodes.size(); ++k) {
            Rgb& node = out_.cube.nodes[k];
            node = to_float(to_double(node) + residual.nodes[k]);
        }
        lut_.cube = out_.cube;
    }

    // Of colours that lie far from what all others around them say (Huber's weights).
    void trust(const std::vector<ColorPair>& means) {
        std::vector<RgbD> expected;
        for (const ColorPair& mean : means) {
            expected.push_back(mean.before);
        }
        apply_in_parallel(look(), expected);
        std::vector<double> off;
        for (std::size_t i = 0; i < means.size(); ++i) {
            off.push_back(largest_magnitude(off_by(means[i].after, expected[i], means[i].clipped)));
        }
        std::vector<double> sorted = off;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        const double limit = std::max(color_doubt * *middle, never_doubted);
        for (std::size_t i = 0; i < off.size(); ++i) {
            trust_[i] = off[i] > limit ? squared(limit / off[i]) : 1;
        }
    }

    ColorBins bins_;
    int size_;
    Lut3D identity_ = identity_cube(size_), base_ = identity_;
    double least_noise_, noise_;
    std::vector<double> trust_; ///< of each bin, 0..1
    Lut lut_;
    Match out_;
};

} // namespace

Match match_look(std::vector<PixelPair> pixels, const MatchSettings& settings, const Match* start) {
    check_cube_size(settings.size);
    return Learning(std::move(pixels), settings).run(start);
}

} // namespace lutlib
