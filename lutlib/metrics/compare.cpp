#include "lutlib/metrics/compare.h"

#include "lutlib/color/difference_all.h"
#include "lutlib/metrics/samples.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr double diffuse_white_nits = 100;

// To the eye: the colours of both sides from codes to light and on to each metric's own space, in
// pieces that stay in the first-level cache.
class EyeDifference {
  public:
    explicit EyeDifference(const Encoding& output)
        : output_(output), to_rec709_(rgb_to_rgb(output.primaries(), rec709)),
          to_rec2020_nits_(rgb_to_rgb(output.primaries(), rec2020) *
                           diagonal({diffuse_white_nits, diffuse_white_nits, diffuse_white_nits})) {
    }

    void operator()(std::span<const RgbD> a, std::span<const RgbD> b, std::span<double> lab,
                    std::span<double> itp) const {
        for (std::size_t first = 0; first < a.size(); first += piece) {
            const std::size_t count = std::min(piece, a.size() - first);
            run(a.subspan(first, count), b.subspan(first, count), lab.subspan(first, count),
                itp.subspan(first, count));
        }
    }

  private:
    static constexpr std::size_t piece = 128;

    struct Side {
        std::array<RgbD, piece> light, mapped;
        std::array<Lab, piece> lab;
    };

    void run(std::span<const RgbD> a, std::span<const RgbD> b, std::span<double> lab,
             std::span<double> itp) const {
        const std::size_t count = a.size();
        Side p, q;
        const auto see = [&](std::span<const RgbD> codes, Side& side) {
            std::copy(codes.begin(), codes.end(), side.light.begin());
            const auto light = std::span(side.light).first(count);
            output_.decode_all(light);
            for (std::size_t i = 0; i < count; ++i) {
                // The curves for many colours at once may take a broken one for a finite one.
                const bool broken = !std::isfinite(largest_magnitude(codes[i]));
                side.light[i] = broken ? RgbD{INFINITY, INFINITY, INFINITY} : side.light[i];
                side.mapped[i] = to_rec709_ * side.light[i];
            }
            lab_from_linear_all(std::span(side.mapped).first(count),
                                std::span(side.lab).first(count));
            for (std::size_t i = 0; i < count; ++i) {
                side.mapped[i] = to_rec2020_nits_ * side.light[i];
            }
        };
        see(a, p);
        see(b, q);
        delta_e_2000_all(std::span(p.lab).first(count), std::span(q.lab).first(count), lab);
        delta_e_itp_nits_all(std::span(p.mapped).first(count), std::span(q.mapped).first(count),
                             itp);
    }

    Encoding output_;
    Matrix3 to_rec709_, to_rec2020_nits_;
};

} // namespace

Difference compare(const Transform& a, const Transform& b, const std::vector<Rgb>& inputs,
                   const Encoding& output) {
    return difference_of(inputs, images_of(a, inputs), images_of(b, inputs), output);
}

Difference difference_of(const std::vector<Rgb>& inputs, const std::vector<RgbD>& a,
                         const std::vector<RgbD>& b, const Encoding& output) {
    const std::size_t count = inputs.size();
    std::vector<double> absolute(count), lab(count), itp(count), square(count);
    const EyeDifference to_eye(output);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const RgbD d = a[i] - b[i];
            absolute[i] = largest_magnitude(d);
            square[i] = d.r * d.r + d.g * d.g + d.b * d.b;
        }
        const std::size_t first = range.begin(), n = range.size();
        to_eye(std::span(a).subspan(first, n), std::span(b).subspan(first, n),
               std::span(lab).subspan(first, n), std::span(itp).subspan(first, n));
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
    return over_domain(sample_colors(lattice_size, counts), domain);
}

} // namespace lutlib
