#include "lutlib/bake/promise.h"

#include "lutlib/color/encoding.h"
#include "lutlib/metrics/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr SampleCounts first_glance{.neutral = 64, .random = 4096, .lattice = false};
// Colours looked at before the first that breaks the promise ends it.
constexpr std::size_t at_once = 64, in_parallel = 8192;
// Room for the whole union grid of 33 and 128 nodes, and as many of its middles: a part of them may
// miss what breaks the promise.
constexpr std::size_t whole_grid = std::size_t{1} << 22;

RgbD through_srgb(double (Encoding::*f)(double) const, RgbD c) {
    return {(srgb().*f)(c.r), (srgb().*f)(c.g), (srgb().*f)(c.b)};
}

} // namespace

PromiseCheck::PromiseCheck(const Transform& look, const Engine& engine, const Budget& budget)
    : engine_(engine), budget_(budget), look_(held_to_codes(look)), eye_(budget.viewing),
      remembered_(sample_colors(2, first_glance)), expected_(images_of(look_, remembered_)) {}

// What the engine's lookup weighs, without the picture.
std::vector<RgbD> PromiseCheck::read_point_samples(int size, CodeDepth depth,
                                                   std::span<const Rgb> in) const {
    const LatticeReader reader = reader_of(engine_, size);
    std::vector<NodeWeights> weights;
    std::vector<RgbD> nodes;
    for (const Rgb& colour : in) {
        weights.push_back(reader.weights(to_double(colour)));
        const NodeWeights& w = weights.back();
        for (std::size_t k = 0; k < w.count; ++k) {
            const auto n = static_cast<std::size_t>(size);
            const auto input = [&](std::size_t i) {
                return engine_.node_input(static_cast<int>(i), size);
            };
            nodes.push_back(
                {input(w.node[k] % n), input(w.node[k] / n % n), input(w.node[k] / n / n)});
        }
    }
    look_(nodes);
    const bool light = engine_.filtering == Filtering::light;
    std::vector<RgbD> out;
    auto node = nodes.begin();
    for (const NodeWeights& w : weights) {
        RgbD sum;
        for (std::size_t k = 0; k < w.count; ++k, ++node) {
            RgbD code;
            for (std::size_t c = 0; c < 3; ++c) {
                code[c] = depth.value(depth.code((*node)[c]));
            }
            sum = sum + w.weight[k] * (light ? through_srgb(&Encoding::decode, code) : code);
        }
        out.push_back(light ? through_srgb(&Encoding::encode, sum) : sum);
    }
    return out;
}

double PromiseCheck::glance(int size, int bits, double limit) {
    double largest = 0;
    for (std::size_t first = 0; first < remembered_.size(); first += at_once) {
        const std::size_t count = std::min(at_once, remembered_.size() - first);
        const std::vector<RgbD> got =
            read_point_samples(size, {bits}, std::span(remembered_).subspan(first, count));
        std::array<double, at_once> error{};
        const auto errors = std::span(error).first(count);
        eye_(budget_.metric, std::span(expected_).subspan(first, count), got, errors);
        const auto worst = std::max_element(errors.begin(), errors.end());
        largest = std::max(largest, *worst);
        if (largest > limit) {
            const std::size_t at = first + static_cast<std::size_t>(worst - errors.begin());
            std::swap(remembered_.front(), remembered_[at]);
            std::swap(expected_.front(), expected_[at]);
            break;
        }
    }
    return largest;
}

void PromiseCheck::remember(std::span<const Rgb> colours, std::span<const double> errors) {
    constexpr double nearly = 0.8;
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (errors[i] > nearly * budget_.most) {
            worst.push_back(i);
        }
    }
    const std::size_t count = std::min(at_once, worst.size());
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(count),
                      worst.end(), [&](std::size_t a, std::size_t b) {
                          return errors[a] != errors[b] ? errors[a] > errors[b] : a < b;
                      });
    std::vector<Rgb> kept;
    for (std::size_t i = 0; i < count; ++i) {
        kept.push_back(colours[worst[i]]);
    }
    const std::vector<RgbD> right = images_of(look_, kept);
    remembered_.insert(remembered_.begin(), kept.begin(), kept.end());
    expected_.insert(expected_.begin(), right.begin(), right.end());
}

double PromiseCheck::largest_error(const Bake& bake, double limit) {
    if (samples_size_ != bake.size) {
        samples_size_ = bake.size;
        samples_ =
            error_samples({}, united(budget_.breaks, breaks_of(reader_of(engine_, bake.size))),
                          {.grid = whole_grid, .between = whole_grid});
        samples_.hiding.insert(samples_.hiding.end(), samples_.even.begin(), samples_.even.end());
        right_.clear();
    }
    const std::vector<Rgb>& colours = samples_.hiding;
    const Transform lookup = read_by(engine_, decoded(bake.picture), bake.size);
    std::vector<double> errors(colours.size());
    for (std::size_t first = 0; first < colours.size(); first += in_parallel) {
        const std::size_t count = std::min(in_parallel, colours.size() - first);
        const auto part = std::span(colours).subspan(first, count);
        if (right_.size() <= first) {
            const std::vector<RgbD> right = images_of(look_, part);
            right_.insert(right_.end(), right.begin(), right.end());
        }
        const std::vector<RgbD> got = images_of(lookup, part);
        const auto error = std::span(errors).subspan(first, count);
        eye_(budget_.metric, std::span(right_).subspan(first, count), got, error);
        const double worst = *std::max_element(error.begin(), error.end());
        if (worst > limit) {
            remember(part, error);
            return worst;
        }
    }
    const Peak peak = climbed(
        colours, errors, samples_.axis, [&](std::span<const Rgb> in, std::span<double> error) {
            const std::vector<RgbD> right = images_of(look_, in), got = images_of(lookup, in);
            eye_(budget_.metric, right, got, error);
        });
    if (peak.error > budget_.most) {
        remember(std::span(&peak.at, 1), std::span(&peak.error, 1));
    }
    return peak.error;
}

} // namespace lutlib
