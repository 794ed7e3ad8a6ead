#include "lutlib/metrics/compare.h"

#include "lutlib/metrics/samples.h"
#include "lutlib/metrics/suspects.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// The errors of colours by each metric.
struct Errors {
    std::array<std::vector<double>, metric_count> of;

    explicit Errors(std::size_t count) { of.fill(std::vector<double>(count)); }
    std::span<double> by(Metric metric, std::size_t first, std::size_t count) {
        return std::span(of[static_cast<std::size_t>(metric)]).subspan(first, count);
    }
    void fill(const Eye& eye, std::span<const RgbD> a, std::span<const RgbD> b, std::size_t first) {
        eye(Metric::code, a, b, by(Metric::code, first, a.size()));
        eye.both(a, b, by(Metric::delta_e_2000, first, a.size()),
                 by(Metric::delta_e_itp, first, a.size()));
    }
};

// What both make of a few dozen or hundred colours.
struct Pair {
    std::vector<RgbD> a, b;

    Pair(const Transform& first, const Transform& second, std::span<const Rgb> inputs)
        : a(inputs.size()), b(inputs.size()) {
        std::transform(inputs.begin(), inputs.end(), a.begin(), to_double);
        b = a;
        first(a);
        second(b);
    }
};

template <class F>
void in_pieces(std::size_t count, F&& f) {
    constexpr std::size_t piece = 512;
    tbb::parallel_for(std::size_t{0}, (count + piece - 1) / piece,
                      [&](std::size_t k) { f(k * piece, std::min(piece, count - k * piece)); });
}

ErrorsOf errors_by(const Transform& a, const Transform& b, const Eye& eye, Metric metric) {
    return [&, metric](std::span<const Rgb> colors, std::span<double> errors) {
        const Pair pair(a, b, colors);
        eye(metric, pair.a, pair.b, errors);
    };
}

// The even ones first.
std::vector<Rgb> all_of(const ErrorSamples& samples, const Transform& a, const Transform& b,
                        const Viewing& viewing) {
    std::vector<Rgb> out = samples.even;
    out.insert(out.end(), samples.hiding.begin(), samples.hiding.end());
    if (samples.suspects.cells + samples.suspects.nodes > 0) {
        const std::vector<Rgb> more = suspects(a, b, samples.axis, viewing, samples.suspects);
        out.insert(out.end(), more.begin(), more.end());
    }
    return out;
}

void fill_all(Errors& errors, const Eye& eye, std::span<const RgbD> a, std::span<const RgbD> b) {
    in_pieces(a.size(), [&](std::size_t first, std::size_t n) {
        errors.fill(eye, a.subspan(first, n), b.subspan(first, n), first);
    });
}

Difference summary(const std::vector<Rgb>& inputs, const std::vector<RgbD>& a,
                   const std::vector<RgbD>& b, Errors errors) {
    const std::size_t count = inputs.size();
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const RgbD d = a[i] - b[i];
        sum += d.r * d.r + d.g * d.g + d.b * d.b;
    }
    Difference out;
    out.psnr = count ? -10 * std::log10(sum / (3 * static_cast<double>(count))) : INFINITY;
    out.absolute = error_stats(std::move(errors.of[0]));
    out.delta_e_2000 = error_stats(std::move(errors.of[1]));
    out.delta_e_itp = error_stats(std::move(errors.of[2]));
    const auto at = [&](std::size_t i) {
        return count ? WorstColor{inputs[i], a[i], b[i]} : WorstColor{};
    };
    out.worst = at(out.absolute.worst);
    out.worst_to_eye = at(out.delta_e_2000.worst);
    out.worst_to_itp = at(out.delta_e_itp.worst);
    return out;
}

WorstColor worst_at(const Transform& a, const Transform& b, Rgb in) {
    return {in, a(to_double(in)), b(to_double(in))};
}

} // namespace

Difference measure(const Transform& a, const Transform& b, const ErrorSamples& samples,
                   const Viewing& viewing) {
    const Eye eye(viewing);
    const std::vector<Rgb> colors = all_of(samples, a, b, viewing);
    const std::vector<RgbD> even_a = images_of(a, samples.even),
                            even_b = images_of(b, samples.even);
    const std::size_t even = samples.even.size();
    Errors errors(colors.size());
    fill_all(errors, eye, even_a, even_b);
    in_pieces(colors.size() - even, [&](std::size_t first, std::size_t count) {
        const Pair pair(a, b, std::span(colors).subspan(even + first, count));
        errors.fill(eye, pair.a, pair.b, even + first);
    });
    Errors of_even(0);
    for (std::size_t k = 0; k < metric_count; ++k) {
        const auto begin = errors.of[k].begin();
        of_even.of[k].assign(begin, begin + static_cast<std::ptrdiff_t>(even));
    }
    Difference out = summary(samples.even, even_a, even_b, std::move(of_even));
    const std::array<std::pair<ErrorStats*, WorstColor*>, metric_count> to{
        {{&out.absolute, &out.worst},
         {&out.delta_e_2000, &out.worst_to_eye},
         {&out.delta_e_itp, &out.worst_to_itp}}};
    for (const MetricInfo& metric : metrics()) {
        const auto k = static_cast<std::size_t>(metric.kind);
        const Peak peak =
            climbed(colors, errors.of[k], samples.axis, errors_by(a, b, eye, metric.kind));
        to[k].first->max = peak.error;
        to[k].first->at = peak.at;
        to[k].first->largest_seen = !samples.whole;
        *to[k].second = worst_at(a, b, peak.at);
    }
    return out;
}

Peak largest_difference(const Transform& a, const Transform& b, const ErrorSamples& samples,
                        const Viewing& viewing, Metric metric) {
    const Eye eye(viewing);
    const ErrorsOf errors_of = errors_by(a, b, eye, metric);
    const std::vector<Rgb> colors = all_of(samples, a, b, viewing);
    std::vector<double> errors(colors.size());
    in_pieces(colors.size(), [&](std::size_t first, std::size_t count) {
        errors_of(std::span(colors).subspan(first, count), std::span(errors).subspan(first, count));
    });
    return climbed(colors, errors, samples.axis, errors_of);
}

Difference compare(const Transform& a, const Transform& b, const std::vector<Rgb>& inputs,
                   const Viewing& viewing) {
    return difference_of(inputs, images_of(a, inputs), images_of(b, inputs), viewing);
}

Difference difference_of(const std::vector<Rgb>& inputs, const std::vector<RgbD>& a,
                         const std::vector<RgbD>& b, const Viewing& viewing) {
    Errors errors(inputs.size());
    fill_all(errors, Eye(viewing), a, b);
    return summary(inputs, a, b, std::move(errors));
}

std::vector<Rgb> samples_over(const Domain& domain, int lattice_size, int random_count) {
    SampleCounts counts;
    counts.random = random_count;
    return over_domain(sample_colors(lattice_size, counts), domain);
}

} // namespace lutlib
