#include "lutlib/color/transfer.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr double largest_light = 65504;
constexpr double pq_white_nits = 100;

// ARRI's published constants for EI 800.
namespace logc3 {
constexpr double cut = 0.010591, a = 5.555556, b = 0.052272, c = 0.247190, d = 0.385537,
                 e = 5.367655, f = 0.092809;
}

namespace pq {
constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 4096 * 128, c1 = 3424.0 / 4096,
                 c2 = 2413.0 / 4096 * 32, c3 = 2392.0 / 4096 * 32, peak = 10000;
}

} // namespace

double srgb_decode(double code) {
    const double x = std::abs(code);
    const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    return std::copysign(linear, code);
}

double srgb_encode(double linear) {
    const double x = std::abs(linear);
    const double code = x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return std::copysign(code, linear);
}

double gamma24_decode(double code) {
    return std::copysign(std::pow(std::abs(code), 2.4), code);
}

double gamma24_encode(double linear) {
    return std::copysign(std::pow(std::abs(linear), 1 / 2.4), linear);
}

double logc3_decode(double code) {
    using namespace logc3;
    if (code <= e * cut + f) {
        return (code - f) / e;
    }
    return std::min((std::pow(10, (code - d) / c) - b) / a, largest_light);
}

double logc3_encode(double linear) {
    using namespace logc3;
    return linear > cut ? c * std::log10(a * std::min(linear, largest_light) + b) + d
                        : e * linear + f;
}

double acescct_decode(double code) {
    if (code <= 0.155251141552511) {
        return (code - 0.0729055341958355) / 10.5402377416545;
    }
    return std::min(std::exp2(code * 17.52 - 9.72), largest_light);
}

double acescct_encode(double linear) {
    return linear <= 0.0078125 ? 10.5402377416545 * linear + 0.0729055341958355
                               : (std::log2(std::min(linear, largest_light)) + 9.72) / 17.52;
}

double pq_from_nits(double nits) {
    const double y = std::clamp(nits / pq::peak, 0.0, 1.0);
    const double p = std::pow(y, pq::m1);
    return std::pow((pq::c1 + pq::c2 * p) / (1 + pq::c3 * p), pq::m2);
}

double nits_from_pq(double code) {
    const double p = std::pow(std::clamp(code, 0.0, 1.0), 1 / pq::m2);
    return pq::peak * std::pow(std::max(p - pq::c1, 0.0) / (pq::c2 - pq::c3 * p), 1 / pq::m1);
}

double pq_decode(double code) {
    return nits_from_pq(code) / pq_white_nits;
}

double pq_encode(double linear) {
    return pq_from_nits(linear * pq_white_nits);
}

} // namespace lutlib
