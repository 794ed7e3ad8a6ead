#include "lutlib/color/difference.h"

#include "lutlib/color/difference_constants.h"
#include "lutlib/color/transfer.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace lutlib {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double degree = std::numbers::pi / 180;

constexpr Matrix3 rec709_to_rec2020 = rgb_to_rgb(rec709, rec2020);

bool finite(RgbD c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

RgbD srgb_to_linear(RgbD c) {
    return {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)};
}

double lab_curve(double t) {
    return t > lab_cut ? std::cbrt(t) : t * lab_slope + lab_offset;
}

double square(double x) {
    return x * x;
}

double hue_degrees(double a, double b) {
    const double h = a == 0 && b == 0 ? 0 : std::atan2(b, a) / degree;
    return h < 0 ? h + 360 : h;
}

RgbD itp(RgbD rec2020_nits) {
    const RgbD lms = rec2020_to_lms * rec2020_nits;
    return pq_lms_to_itp * RgbD{pq_from_nits(lms.r), pq_from_nits(lms.g), pq_from_nits(lms.b)};
}

} // namespace

Lab lab_from_linear(RgbD linear_rec709) {
    const RgbD xyz = rec709_to_xyz * linear_rec709;
    const double x = lab_curve(xyz.r / lab_white.r), y = lab_curve(xyz.g / lab_white.g),
                 z = lab_curve(xyz.b / lab_white.b);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Lab lab_from_srgb(RgbD srgb_encoded) {
    return lab_from_linear(srgb_to_linear(srgb_encoded));
}

// The symbols are the paper's, its equations (2) to (22).
double delta_e_2000(Lab p, Lab q) {
    if (!finite({p.L, p.a, p.b}) || !finite({q.L, q.a, q.b})) {
        return infinity;
    }
    const auto chroma_weight = [](double c) {
        const double c7 = std::pow(c, 7);
        return std::isfinite(c7) ? std::sqrt(c7 / (c7 + 6103515625.0)) : 1.0; // 25^7
    };
    const double mean_c = (std::hypot(p.a, p.b) + std::hypot(q.a, q.b)) / 2;
    const double g = 0.5 * (1 - chroma_weight(mean_c));
    const double a1 = (1 + g) * p.a, a2 = (1 + g) * q.a;
    const double c1 = std::hypot(a1, p.b), c2 = std::hypot(a2, q.b);
    const double h1 = hue_degrees(a1, p.b), h2 = hue_degrees(a2, q.b);
    const bool neutral = c1 * c2 == 0;

    double dh = neutral ? 0 : h2 - h1;
    dh += dh > 180 ? -360 : dh < -180 ? 360 : 0;
    double mean_h = h1 + h2;
    if (!neutral) {
        const double wrap = std::abs(h1 - h2) <= 180 ? 0 : mean_h < 360 ? 360 : -360;
        mean_h = (mean_h + wrap) / 2;
    }

    const double dL = q.L - p.L, dC = c2 - c1;
    const double dH = 2 * std::sqrt(c1) * std::sqrt(c2) * std::sin(dh / 2 * degree);
    const double mean_L = (p.L + q.L) / 2, mean_cp = (c1 + c2) / 2;
    const double t =
        1 - 0.17 * std::cos((mean_h - 30) * degree) + 0.24 * std::cos(2 * mean_h * degree) +
        0.32 * std::cos((3 * mean_h + 6) * degree) - 0.20 * std::cos((4 * mean_h - 63) * degree);
    const double rotation = 30 * std::exp(-square((mean_h - 275) / 25));
    const double s_l = 1 + 0.015 * square(mean_L - 50) / std::hypot(std::sqrt(20.0), mean_L - 50);
    const double s_c = 1 + 0.045 * mean_cp;
    const double s_h = 1 + 0.015 * mean_cp * t;
    const double r_t = -std::sin(2 * rotation * degree) * 2 * chroma_weight(mean_cp);
    const double l = dL / s_l, c = dC / s_c, h = dH / s_h;
    // The rotation term may leave a rounding error below zero for equal colours.
    return std::sqrt(std::max(0.0, l * l + c * c + h * h + r_t * c * h));
}

double delta_e_2000(RgbD srgb_encoded_a, RgbD srgb_encoded_b) {
    if (!finite(srgb_encoded_a) || !finite(srgb_encoded_b)) {
        return infinity;
    }
    return delta_e_2000(lab_from_srgb(srgb_encoded_a), lab_from_srgb(srgb_encoded_b));
}

double delta_e_itp_nits(RgbD rec2020_nits_a, RgbD rec2020_nits_b) {
    if (!finite(rec2020_nits_a) || !finite(rec2020_nits_b)) {
        return infinity;
    }
    const RgbD d = itp(rec2020_nits_a) - itp(rec2020_nits_b);
    return 720 * std::sqrt(d.r * d.r + d.g * d.g + d.b * d.b);
}

double delta_e_itp(RgbD srgb_encoded_a, RgbD srgb_encoded_b, double white_nits) {
    if (!finite(srgb_encoded_a) || !finite(srgb_encoded_b)) {
        return infinity;
    }
    const auto nits = [white_nits](RgbD c) {
        return white_nits * (rec709_to_rec2020 * srgb_to_linear(c));
    };
    return delta_e_itp_nits(nits(srgb_encoded_a), nits(srgb_encoded_b));
}

} // namespace lutlib
