// Apple: Apple Log, which is recorded with Rec.2020's primaries.
#include "lutlib/color/rows/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// "Apple Log Profile White Paper" (2023): a parabola from r0 to rt, a logarithm above.
constexpr double r0 = -0.05641088, rt = 0.01, c = 47.28711236, beta = 0.00964052,
                 gamma = 0.08550479, delta = 0.69336945;
constexpr double code_cut = c * (rt - r0) * (rt - r0);

double decode(double code) {
    if (code < code_cut) {
        return std::sqrt(std::max(code, 0.0) / c) + r0;
    }
    return std::clamp(std::exp2((std::min(code, 4.0) - delta) / gamma) - beta, rt, largest_light);
}

double encode(double linear) {
    const double x = std::clamp(linear, r0, largest_light);
    return x < rt ? c * (x - r0) * (x - r0)
                  : std::max(gamma * std::log2(x + beta) + delta, code_cut);
}

} // namespace

/// Light below -0.056 and codes below 0 are black's end of the parabola.
constinit const TransferCurve curve::applelog{.name = "applelog",
                                              .label = "Apple Log",
                                              .source =
                                                  "Apple, Apple Log Profile White Paper (2023)",
                                              .gamut = &gamut::rec2020,
                                              .darkest = r0,
                                              .brightest = largest_light,
                                              .decode = decode,
                                              .encode = encode,
                                              .decode_all = each_channel<decode>,
                                              .encode_all = each_channel<encode>};

} // namespace lutlib
