#include "lutlib/color/transfer.h"

#include "lutlib/color/transfer_constants.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
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
    using namespace acescct;
    if (code <= code_cut) {
        return (code - offset) / slope;
    }
    return std::min(std::exp2(code * stops - lowest), largest_light);
}

double acescct_encode(double linear) {
    using namespace acescct;
    return linear <= light_cut ? slope * linear + offset
                               : (std::log2(std::min(linear, largest_light)) + lowest) / stops;
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
