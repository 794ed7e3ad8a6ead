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
