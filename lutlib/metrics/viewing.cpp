#include "lutlib/metrics/viewing.h"

#include "lutlib/color/difference_all.h"
#include "lutlib/color/rows/all.h"
#include "lutlib/color/transfer_constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array<MetricInfo, metric_count> metric_rows{{
    {Metric::code, "absolute", "code values"},
    {Metric::delta_e_2000, "delta_e_2000", "dE2000"},
    {Metric::delta_e_itp, "delta_e_itp", "dE-ITP"},
}};

// Pieces stay in the first-level cache.
constexpr std::size_t piece = 128;

double nits_of_light(const Viewing& v) {
    return v.output.curve == &curve::pq ? pq_white_nits : v.reference_white;
}

Matrix3 scaled(double by, const Matrix3& matrix) {
    return matrix * diagonal({by, by, by});
}

struct Side {
    std::array<RgbD, piece> light, mapped;
    std::array<Lab, piece> lab;
};

} // namespace

bool is_hdr(const Encoding& encoding) {
    return encoding.curve == &curve::pq || encoding.curve == &curve::hlg;
}

std::span<const MetricInfo, metric_count> metrics() {
    return metric_rows;
}

Matrix3 light_to_rec709(const Viewing& viewing) {
    return scaled(nits_of_light(viewing) / viewing.reference_white,
                  rgb_to_rgb(viewing.output.primaries(), rec709));
}

Eye::Eye(const Viewing& viewing)
    : output_(viewing.output), to_rec709_(light_to_rec709(viewing)),
      to_rec2020_nits_(
          scaled(nits_of_light(viewing), rgb_to_rgb(viewing.output.primaries(), rec2020))) {}

void Eye::both(std::span<const RgbD> a, std::span<const RgbD> b, std::span<double> delta_e_2000,
               std::span<double> delta_e_itp) const {
    for (std::size_t first = 0; first < a.size(); first += piece) {
        const std::size_t count = std::min(piece, a.size() - first);
        Side p, q;
        const auto see = [&](std::span<const RgbD> codes, Side& side) {
            std::copy(codes.begin(), codes.end(), side.light.begin());
            const auto light = std::span(side.light).first(count);
            output_.decode_all(light);
            for (std::size_t i = 0; i < count; ++i) {
                // The curves for many colours at once may take a broken one for a finite one.
                const bool broken = !std::isfinite(largest_magnitude(codes[i]));
                side.light[i] = broken ? RgbD{INFINITY, INFINITY, INFINITY} : side.light[i];
            }
        };
        const auto map = [&](const Matrix3& matrix) {
            for (Side* side : {&p, &q}) {
                for (std::size_t i = 0; i < count; ++i) {
                    side->mapped[i] = matrix * side->light[i];
                }
            }
        };
        see(a.subspan(first, count), p);
        see(b.subspan(first, count), q);
        if (!delta_e_2000.empty()) {
            map(to_rec709_);
            for (Side* side : {&p, &q}) {
                lab_from_linear_all(std::span(side->mapped).first(count),
                                    std::span(side->lab).first(count));
            }
            delta_e_2000_all(std::span(p.lab).first(count), std::span(q.lab).first(count),
                             delta_e_2000.subspan(first, count));
        }
        if (!delta_e_itp.empty()) {
            map(to_rec2020_nits_);
            delta_e_itp_nits_all(std::span(p.mapped).first(count), std::span(q.mapped).first(count),
                                 delta_e_itp.subspan(first, count));
        }
    }
}

void Eye::operator()(Metric metric, std::span<const RgbD> a, std::span<const RgbD> b,
                     std::span<double> errors) const {
    switch (metric) {
    case Metric::code:
        std::transform(a.begin(), a.end(), b.begin(), errors.begin(),
                       [](RgbD x, RgbD y) { return largest_magnitude(x - y); });
        break;
    case Metric::delta_e_2000:
        both(a, b, errors, {});
        break;
    case Metric::delta_e_itp:
        both(a, b, {}, errors);
        break;
    }
}

} // namespace lutlib
