// Kodak Cineon, as scanned film is converted to light.
#include "lutlib/color/rows/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// Kodak, "Conversion of 10-bit Log Film Data To 8-bit Linear or Video Data for The Cineon Digital
// Film System" (1995): white at 685, black at 95, 0.002 density a code, negative gamma 0.6.
constexpr double white = 685, per_code = 0.002 / 0.6, codes = 1023;
constexpr double black = 0.0107977516232771;     // 10^((95 - 685) per_code)
constexpr double lowest = 0.0052079483285954594; // 10^((0 - 685) per_code), where code 0 lies

double decode(double code) {
    const double x = std::pow(10, (std::clamp(code, 0.0, 4.0) * codes - white) * per_code);
    return std::min((x - black) / (1 - black), largest_light);
}

double encode(double linear) {
    const double x = std::min(linear, largest_light) * (1 - black) + black;
    return (white + std::log10(std::max(x, lowest)) / per_code) / codes;
}

} // namespace

/// No gamut is published: film is taken for Rec.709. Codes below 0 are code 0.
constinit const TransferCurve curve::cineon{.name = "cineon",
                                            .label = "Cineon",
                                            .source =
                                                "Kodak, Conversion of 10-bit Log Film Data (1995)",
                                            .gamut = &gamut::rec709,
                                            .darkest = (lowest - black) / (1 - black),
                                            .brightest = largest_light,
                                            .decode = decode,
                                            .encode = encode,
                                            .decode_all = each_channel<decode>,
                                            .encode_all = each_channel<encode>};

} // namespace lutlib
