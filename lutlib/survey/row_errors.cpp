#include "lutlib/survey/row_errors.h"

#include "lutlib/metrics/climb.h"
#include "lutlib/metrics/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace lutlib {
namespace {

constexpr std::size_t climbers = 12, looks = 8, directions = 24;
constexpr float shrink = 0.7F;

// Between two nodes of an axis, at most.
float widest(const std::vector<float>& axis) {
    float out = 0;
    for (std::size_t i = 1; i < axis.size(); ++i) {
        out = std::max(out, axis[i] - axis[i - 1]);
    }
    return out;
}

// Directions of -1..1 each way, others at each look.
const std::vector<Rgb>& looks_around() {
    static const std::vector<Rgb> out = [] {
        std::vector<Rgb> colors = sample_colors(2, {.neutral = 2,
                                                    .random = static_cast<int>(looks * directions),
                                                    .lattice = false,
                                                    .skipped = 0});
        colors.erase(colors.begin(), colors.begin() + 10);
        for (Rgb& c : colors) {
            c = c * 2.0F - Rgb{1, 1, 1};
        }
        return colors;
    }();
    return out;
}

template <class ErrorsOf>
Peak uphill(Peak from, const std::array<std::vector<float>, 3>& axis, const ErrorsOf& errors_of) {
    std::array<float, 3> reach{widest(axis[0]), widest(axis[1]), widest(axis[2])};
    std::vector<Rgb> next(directions);
    for (std::size_t look = 0; look < looks; ++look) {
        for (std::size_t i = 0; i < directions; ++i) {
            const Rgb& direction = looks_around()[look * directions + i];
            for (std::size_t c = 0; c < 3; ++c) {
                next[i][c] = std::clamp(from.at[c] + direction[c] * reach[c], axis[c].front(),
                                        axis[c].back());
            }
        }
        const std::vector<double> errors = errors_of(next);
        const auto best = std::max_element(errors.begin(), errors.end());
        if (*best > from.error) {
            from = {*best, next[static_cast<std::size_t>(best - errors.begin())]};
        } else {
            for (float& r : reach) {
                r *= shrink;
            }
        }
    }
    return from;
}

struct Answers {
    const std::vector<Rgb>& in;
    const std::vector<RgbD>& expected;
    std::vector<RgbD> got;
};

} // namespace

Difference row_errors(const SurveyReference& reference, const Transform& read,
                      const LatticeSamples& samples, std::vector<double>& even_errors) {
    const Eye eye(reference.viewing);
    const std::array<Answers, 2> answers{
        {{reference.inputs, reference.expected, images_of(read, reference.inputs)},
         {samples.at.hiding, samples.expected, images_of(read, samples.at.hiding)}}};
    Difference out =
        difference_of(reference.inputs, reference.expected, answers[0].got, reference.viewing);
    const std::array<std::pair<ErrorStats*, WorstColor*>, metric_count> to{
        {{&out.absolute, &out.worst},
         {&out.delta_e_2000, &out.worst_to_eye},
         {&out.delta_e_itp, &out.worst_to_itp}}};
    for (const MetricInfo& metric : metrics()) {
        std::vector<Peak> seeds;
        for (const Answers& a : answers) {
            std::vector<double> errors(a.in.size());
            eye(metric.kind, a.expected, a.got, errors);
            std::vector<std::size_t> order(errors.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            const std::size_t count = std::min(climbers, order.size());
            std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                              order.end(),
                              [&](std::size_t i, std::size_t k) { return errors[i] > errors[k]; });
            for (std::size_t i = 0; i < count; ++i) {
                seeds.push_back({errors[order[i]], a.in[order[i]]});
            }
            if (metric.kind == Metric::delta_e_2000 && &a == &answers.front()) {
                even_errors = std::move(errors);
            }
        }
        const auto errors_of = [&](const std::vector<Rgb>& colors) {
            std::vector<double> errors(colors.size());
            eye(metric.kind, images_of(reference.shown, colors), images_of(read, colors), errors);
            return errors;
        };
        std::partial_sort(
            seeds.begin(),
            seeds.begin() + static_cast<std::ptrdiff_t>(std::min(climbers, seeds.size())),
            seeds.end(), [](const Peak& a, const Peak& b) { return a.error > b.error; });
        seeds.resize(std::min(climbers, seeds.size()));
        Peak peak;
        for (const Peak& seed : seeds) {
            const Peak found = uphill(seed, samples.at.axis, errors_of);
            peak = found.error > peak.error ? found : peak;
        }
        const auto& [stats, worst] = to[static_cast<std::size_t>(metric.kind)];
        stats->max = peak.error;
        stats->at = peak.at;
        stats->largest_seen = !samples.at.whole;
        *worst = {peak.at, reference.shown(to_double(peak.at)), read(to_double(peak.at))};
    }
    return out;
}

} // namespace lutlib
