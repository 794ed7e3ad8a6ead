// Nikon: N-Log, whose N-Gamut is Rec.2020.
#include "lutlib/color/rows/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// "N-Log Specification Document", version 1.0.0: 650 (x + 0.0075)^(1/3) below light of 0.328 and
// 150 ln x + 619 above, of 1023. The two parts leave a gap of 0.13 of 1023, whose codes become the
// cut's light.
constexpr double codes = 1023, cut = 0.328;

double upper_code(double x) {
    return (150 * std::log(x) + 619) / codes;
}

double decode(double code) {
    if (code < upper_code(cut)) {
        const double root = code * codes / 650;
        return std::clamp(root * root * root - 0.0075, -largest_light, cut);
    }
    return std::clamp(std::exp((std::min(code, 4.0) * codes - 619) / 150), cut, largest_light);
}

double encode(double linear) {
    const double x = std::clamp(linear, -largest_light, largest_light);
    return x < cut ? 650 * std::cbrt(x + 0.0075) / codes : upper_code(x);
}

} // namespace

constinit const TransferCurve curve::nlog{.name = "nlog",
                                          .label = "Nikon N-Log",
                                          .source = "Nikon, N-Log Specification Document, 1.0.0",
                                          .gamut = &gamut::rec2020,
                                          .darkest = -largest_light,
                                          .brightest = largest_light,
                                          .decode = decode,
                                          .encode = encode,
                                          .decode_all = each_channel<decode>,
                                          .encode_all = each_channel<encode>};

} // namespace lutlib
