// GoPro: Protune.
#include "lutlib/color/rows/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// GoPro, "Protune" log of base 113: light of 0..1 at codes of 0..1. Odd, so that black has no end.
constexpr double base = 113;

double decode(double code) {
    const double x = std::pow(base, std::min(std::abs(code), 4.0));
    return std::copysign(std::min((x - 1) / (base - 1), largest_light), code);
}

double encode(double linear) {
    const double x = std::min(std::abs(linear), largest_light);
    return std::copysign(std::log((base - 1) * x + 1) / std::log(base), linear);
}

} // namespace

/// Derived from GoPro's transform to ACES by chromatic adaptation to D65.
constinit const Gamut gamut::protune_native{
    .name = "protune-native",
    .label = "GoPro Protune Native",
    .source = "GoPro's transform to ACES in OpenColorIO-Configs, aces_1.0.3, gopro.py (2016)",
    .primaries = {{.698480461493841, .193026445370121},
                  {.329555378387345, 1.024596624134644},
                  {.108442631407675, -.034678569754016},
                  white_d65}};

constinit const TransferCurve curve::protune{
    .name = "protune",
    .label = "GoPro Protune",
    .source = "GoPro, Protune in OpenColorIO-Configs, aces_1.0.3, gopro.py (2016)",
    .gamut = &gamut::protune_native,
    .darkest = -largest_light,
    .brightest = largest_light,
    .decode = decode,
    .encode = encode,
    .decode_all = each_channel<decode>,
    .encode_all = each_channel<encode>};

} // namespace lutlib
