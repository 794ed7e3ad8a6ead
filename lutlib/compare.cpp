#include "lutlib/compare.h"

#include "lutlib/color/difference.h"
#include "lutlib/samples.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr double diffuse_white_nits = 100;

} // namespace

Difference compare(const Transform& a, const Transform& b, const std::vector<Rgb>& inputs,
                   const Encoding& output) {
    std::vector<RgbD> results_a(inputs.size()), results_b(inputs.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inputs.size(), 1024),
                      [&](const auto& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              results_a[i] = results_b[i] = to_double(inputs[i]);
                          }
                          a(std::span(results_a).subspan(range.begin(), range.size()));
                          b(std::span(results_b).subspan(range.begin(), range.size()));
                      });
    return difference_of(inputs, results_a, results_b, output);
}

Difference difference_of(const std::vector<Rgb>& inputs, const std::vector<RgbD>& a,
                         const std::vector<RgbD>& b, const Encoding& output) {
    const std::size_t count = inputs.size();
    std::vector<double> absolute(count), lab(count), itp(count), square(count);
    const Matrix3 to_rec709 = rgb_to_rgb(output.primaries, rec709);
    const Matrix3 to_rec2020 = rgb_to_rgb(output.primaries, rec2020);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const RgbD p = a[i], q = b[i], d = p - q;
            absolute[i] = largest_magnitude(d);
            square[i] = d.r * d.r + d.g * d.g + d.b * d.b;
            const auto light = [&output](RgbD c) {
                return RgbD{output.decode(c.r), output.decode(c.g), output.decode(c.b)};
            };
            const RgbD light_p = light(p), light_q = light(q);
            lab[i] = delta_e_2000(lab_from_linear(to_rec709 * light_p),
                                  lab_from_linear(to_rec709 * light_q));
            itp[i] = delta_e_itp_nits(diffuse_white_nits * (to_rec2020 * light_p),
                                      diffuse_white_nits * (to_rec2020 * light_q));
        }
    });
    Difference out;
    double sum = 0;
    for (const double s : square) {
        sum += s;
    }
    out.psnr = count ? -10 * std::log10(sum / (3 * static_cast<double>(count))) : INFINITY;
    out.absolute = error_stats(std::move(absolute));
    out.delta_e_2000 = error_stats(std::move(lab));
    out.delta_e_itp = error_stats(std::move(itp));
    const auto at = [&](std::size_t i) {
        return count ? WorstColour{inputs[i], a[i], b[i]} : WorstColour{};
    };
    out.worst = at(out.absolute.worst);
    out.worst_to_eye = at(out.delta_e_2000.worst);
    return out;
}

std::vector<Rgb> samples_over(const Domain& domain, int lattice_size, int random_count) {
    SampleCounts counts;
    counts.random = random_count;
    std::vector<Rgb> out = sample_colors(lattice_size, counts);
    if (!domain.is_unit()) {
        for (Rgb& c : out) {
            for (std::size_t i = 0; i < 3; ++i) {
                c[i] = std::lerp(domain.min[i], domain.max[i], c[i]);
            }
        }
    }
    return out;
}

Transform transform_of(const Lut& lut, Interpolation how) {
    return each_colour([&lut, how](RgbD c) { return evaluate_exact(lut, c, how); });
}

} // namespace lutlib
