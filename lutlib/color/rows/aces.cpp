// The Academy's log encodings and gamuts.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// S-2016-001, 4.3.
constexpr LogLine acescct{.cut = 0.0078125,
                          .a = 1,
                          .b = 0,
                          .c = per_log2 / 17.52,
                          .d = 9.72 / 17.52,
                          .e = 10.5402377416545,
                          .f = 0.0729055341958355};

// S-2014-003, 4.4. Below 2^-15 the logarithm is of half the light above 2^-16, which ends at black.
constexpr double stops = 17.52, lowest = 9.72, toe = 0x1p-15;

double acescc_decode(double code) {
    const double x = std::exp2(std::min(code, 2.0) * stops - lowest);
    return x < toe ? 2 * (x - toe / 2) : std::min(x, largest_light);
}

double acescc_encode(double linear) {
    const double x =
        linear < toe ? toe / 2 + std::max(linear, 0.0) / 2 : std::min(linear, largest_light);
    return (std::log2(x) + lowest) / stops;
}

} // namespace

constinit const Gamut gamut::ap0{
    .name = "ap0",
    .label = "ACES AP0",
    .source = "SMPTE ST 2065-1:2012",
    .primaries = {{.7347, .2653}, {0, 1}, {.0001, -.0770}, {.32168, .33767}}};

constinit const Gamut gamut::ap1{
    .name = "ap1",
    .label = "ACES AP1",
    .source = "S-2014-004",
    .primaries = {{.713, .293}, {.165, .830}, {.128, .044}, {.32168, .33767}}};

/// Light below black is black; codes below black's (-0.358) are light down to -2^-15.
constinit const TransferCurve curve::acescc{.name = "acescc",
                                            .label = "ACEScc",
                                            .source = "S-2014-003",
                                            .gamut = &gamut::ap1,
                                            .darkest = 0,
                                            .brightest = largest_light,
                                            .decode = acescc_decode,
                                            .encode = acescc_encode,
                                            .decode_all = each_channel<acescc_decode>,
                                            .encode_all = each_channel<acescc_encode>};

constinit const TransferCurve curve::acescct =
    log_line_curve<lutlib::acescct>("acescct", "ACEScct", "S-2016-001", &gamut::ap1);

} // namespace lutlib
