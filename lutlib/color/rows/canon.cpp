// Canon: Canon Log, Log 2, Log 3 and Cinema Gamut.
#include "lutlib/color/rows/all.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::string_view transform = "Canon, Input Transform Version 202007 for EOS C300 Mark II";

// Of light over a white of 0.9: code = slope log10(gain x + 1) + offset for light above black, and
// below it, where `below` is the offset, the same turned round. Version 202007 gives them for codes
// as they are recorded.
struct Log {
    double gain, slope, offset, below;
};
constexpr double white = 0.9, largest = largest_light / white;

double above(const Log& p, double code) {
    return (std::pow(10, (std::min(code, 4.0) - p.offset) / p.slope) - 1) / p.gain;
}

double under(const Log& p, double code) {
    return -(std::pow(10, (p.below - std::max(code, -4.0)) / p.slope) - 1) / p.gain;
}

double limited(double x) {
    return white * std::clamp(x, -largest, largest);
}

template <const Log& p>
double decode(double code) {
    return limited(code < p.offset ? under(p, code) : above(p, code));
}

double upward(const Log& p, double x) {
    return p.slope * std::log10(p.gain * x + 1) + p.offset;
}

double downward(const Log& p, double x) {
    return p.below - p.slope * std::log10(1 - p.gain * x);
}

template <const Log& p>
double encode(double linear) {
    const double x = std::clamp(linear / white, -largest, largest);
    return x < 0 ? downward(p, x) : upward(p, x);
}

constexpr Log clog{.gain = 10.1596, .slope = 0.45310179, .offset = 0.12512248, .below = 0.12512248};
constexpr Log clog2{
    .gain = 87.099375, .slope = 0.24136077, .offset = 0.092864125, .below = 0.092864125};

// Log 3 has a line between light of -0.014 and 0.014.
constexpr Log clog3{
    .gain = 14.98325, .slope = 0.36726845, .offset = 0.12240537, .below = 0.12783901};
constexpr double line_slope = 1.9754798, line_offset = 0.12512219, line_end = 0.014;
constexpr double line_low = 0.097465473, line_high = 0.15277891;

double clog3_decode(double code) {
    if (code < line_low) {
        return limited(std::min(under(clog3, code), -line_end));
    }
    if (code <= line_high) {
        return white * std::clamp((code - line_offset) / line_slope, -line_end, line_end);
    }
    return limited(std::max(above(clog3, code), line_end));
}

double clog3_encode(double linear) {
    const double x = std::clamp(linear / white, -largest, largest);
    if (x < -line_end) {
        return std::min(downward(clog3, x), line_low);
    }
    if (x <= line_end) {
        return std::clamp(line_slope * x + line_offset, line_low, line_high);
    }
    return std::max(upward(clog3, x), line_high);
}

constexpr TransferCurve curve_of(std::string_view name, std::string_view label,
                                 double (*decode)(double), double (*encode)(double),
                                 void (*decode_all)(std::span<RgbD>),
                                 void (*encode_all)(std::span<RgbD>)) {
    return {.name = name,
            .label = label,
            .source = transform,
            .gamut = &gamut::cinema_gamut,
            .darkest = -largest_light,
            .brightest = largest_light,
            .decode = decode,
            .encode = encode,
            .decode_all = decode_all,
            .encode_all = encode_all};
}

} // namespace

constinit const Gamut gamut::cinema_gamut{
    .name = "cinema-gamut",
    .label = "Canon Cinema Gamut",
    .source = transform,
    .primaries = {{.740, .270}, {.170, 1.140}, {.080, -.100}, white_d65}};

constinit const TransferCurve curve::clog =
    curve_of("clog", "Canon Log", decode<lutlib::clog>, encode<lutlib::clog>,
             each_channel<decode<lutlib::clog>>, each_channel<encode<lutlib::clog>>);

constinit const TransferCurve curve::clog2 =
    curve_of("clog2", "Canon Log 2", decode<lutlib::clog2>, encode<lutlib::clog2>,
             each_channel<decode<lutlib::clog2>>, each_channel<encode<lutlib::clog2>>);

constinit const TransferCurve curve::clog3 =
    curve_of("clog3", "Canon Log 3", clog3_decode, clog3_encode, each_channel<clog3_decode>,
             each_channel<clog3_encode>);

} // namespace lutlib
