#include "lutlib/fit/acceptance.h"

#include "lutlib/fit/samples.h"
#include "lutlib/metrics/error_samples.h"
#include "lutlib/metrics/samples.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// A fit must be better by more than the noise of the colours it is checked on.
constexpr double least_gain = 0.01;

// Other colours than those that reports are over.
constexpr SampleCounts even_colors{
    .neutral = 0, .random = 40'000, .lattice = false, .skipped = 1'000'000};
constexpr SampleLimits hiding_colors{
    .even = 1, .grid = std::size_t{1} << 17, .between = std::size_t{1} << 16};
constexpr int grey_colors = 256;

std::vector<Rgb> greys(const Domain& domain) {
    std::vector<Rgb> out;
    for (int i = 0; i <= grey_colors; ++i) {
        const float t = static_cast<float>(i) / grey_colors;
        out.push_back({t, t, t});
    }
    return over_domain(std::move(out), domain);
}

// How far the channels' errors are from being the same, which is what tints a grey.
double tint(RgbD error) {
    return std::max({error.r, error.g, error.b}) - std::min({error.r, error.g, error.b});
}

} // namespace

bool within_unit(const std::vector<RgbD>& colors) {
    return std::all_of(colors.begin(), colors.end(), [](RgbD c) { return saturate(c) == c; });
}

Acceptance::Acceptance(const Transform& look, const LatticeReader& reader, const FitView& view)
    : eye_(view.viewing), metric_(eye_metric(view.viewing)) {
    std::vector<Rgb> inputs = over_domain(sample_colors(2, even_colors), reader.domain);
    even_ = inputs.size();
    const std::vector<Rgb> grey = greys(reader.domain);
    neutral_ = grey.size();
    inputs.insert(inputs.end(), grey.begin(), grey.end());
    const ErrorSamples samples =
        error_samples(reader.domain, united(view.breaks, breaks_of(reader)), hiding_colors);
    inputs.insert(inputs.end(), samples.hiding.begin(), samples.hiding.end());
    std::vector<RgbD> colors(inputs.size());
    std::transform(inputs.begin(), inputs.end(), colors.begin(), to_double);
    weights_.resize(colors.size());
    std::transform(colors.begin(), colors.end(), weights_.begin(),
                   [&](RgbD in) { return reader.weights(in); });
    targets_ = mapped(look, std::move(colors));
}

Acceptance::Errors Acceptance::errors(const std::vector<RgbD>& nodes, bool held) const {
    Errors out{std::vector<double>(targets_.size()), std::vector<double>(targets_.size())};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, targets_.size(), 1024),
                      [&](const auto& range) {
                          std::vector<RgbD> got(range.size()), right(range.size());
                          for (std::size_t i = 0; i < range.size(); ++i) {
                              const NodeWeights& w = weights_[range.begin() + i];
                              for (std::size_t k = 0; k < w.count; ++k) {
                                  got[i] = got[i] + w.weight[k] * nodes[w.node[k]];
                              }
                              right[i] = targets_[range.begin() + i];
                              if (held) {
                                  got[i] = saturate(got[i]);
                                  right[i] = saturate(right[i]);
                              }
                          }
                          const auto part = [&](std::vector<double>& errors) {
                              return std::span(errors).subspan(range.begin(), range.size());
                          };
                          eye_(Metric::code, got, right, part(out.code));
                          eye_(metric_, got, right, part(out.eye));
                          // Of greys, the tint stands for the code error.
                          for (std::size_t i = 0; i < range.size(); ++i) {
                              const std::size_t at = range.begin() + i;
                              if (at >= even_ && at < even_ + neutral_) {
                                  out.code[at] = tint(got[i] - right[i]);
                              }
                          }
                      });
    return out;
}

ErrorStats Acceptance::of_even(const std::vector<double>& errors) const {
    return error_stats({errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(even_)});
}

bool Acceptance::within_unit() const {
    return lutlib::within_unit(targets_);
}

FittedLattice Acceptance::accepted(std::vector<RgbD> candidate, const std::vector<RgbD>& plain,
                                   bool held, double tightness) const {
    const Errors before = errors(plain, held);
    const auto first = static_cast<std::ptrdiff_t>(even_),
               last = static_cast<std::ptrdiff_t>(even_ + neutral_);
    const auto largest = [&](const std::vector<double>& e) {
        return std::max(*std::max_element(e.begin(), e.begin() + first),
                        *std::max_element(e.begin() + last, e.end()));
    };
    const double code_cap = tightness * largest(before.code);
    const double eye_cap = tightness * largest(before.eye);
    const double tint_cap =
        *std::max_element(before.code.begin() + first, before.code.begin() + last) + 1e-9;
    Errors now;
    for (bool changed = true; changed;) {
        changed = false;
        now = errors(candidate, held);
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            const bool is_grey = i >= even_ && i < even_ + neutral_;
            if (now.code[i] <= (is_grey ? tint_cap : code_cap) && now.eye[i] <= eye_cap) {
                continue;
            }
            const NodeWeights& w = weights_[i];
            for (std::size_t k = 0; k < w.count; ++k) {
                changed = changed || !(candidate[w.node[k]] == plain[w.node[k]]);
                candidate[w.node[k]] = plain[w.node[k]];
            }
        }
    }
    FittedLattice out;
    out.point_sampled = of_even(before.code);
    const ErrorStats code = of_even(now.code);
    out.fitted = code.mean < (1 - least_gain) * out.point_sampled.mean &&
                 of_even(now.eye).mean < (1 - least_gain) * of_even(before.eye).mean;
    out.result = out.fitted ? code : out.point_sampled;
    out.nodes = out.fitted ? std::move(candidate) : plain;
    return out;
}

} // namespace lutlib
