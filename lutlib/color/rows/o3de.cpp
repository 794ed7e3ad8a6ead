// Open 3D Engine: the shaper of its colour grading.
#include "lutlib/color/rows/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// The component's "Log2 48 nits": 6.5 stops either side of mid grey over 0..1.
constexpr double mid_grey = 0.18, stops = 6.5;
constexpr double darkest = 0.0019887378220871643; // mid_grey / 2^stops
constexpr double brightest = 16.291740238538046;  // mid_grey * 2^stops

double decode(double code) {
    return mid_grey * std::exp2(std::clamp(code, 0.0, 1.0) * (2 * stops) - stops);
}

double encode(double linear) {
    const double x = std::clamp(linear, darkest, brightest);
    return std::clamp((std::log2(x / mid_grey) + stops) / (2 * stops), 0.0, 1.0);
}

} // namespace

/// Light beyond the shaper's 13 stops, black for one, is held to them, as the engine's sampler
/// does.
constinit const TransferCurve curve::o3de_log2{
    .name = "o3de-log2",
    .label = "O3DE shaper Log2 48 nits",
    .source = "O3DE, Look Modification component; AcesDisplayMapper, GetLog2ShaperParameters",
    .gamut = &gamut::ap1,
    .darkest = darkest,
    .brightest = brightest,
    .decode = decode,
    .encode = encode,
    .decode_all = each_channel<decode>,
    .encode_all = each_channel<encode>};

} // namespace lutlib
