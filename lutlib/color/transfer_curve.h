// Transfer curves as rows: code values to linear light and back, one channel at a time. A new one
// is a row in its maker's file in rows/, its line in rows/all.h and its line in encoding.cpp's
// table.
//
// Linear light of 1 is diffuse white: a scene's white of 100 % reflectance (so mid grey is 0.18),
// a display's white, 100 cd/m2 in PQ. Codes are fractions of full range, where a maker publishes
// 10-bit codes of n / 1023.
#pragma once

#include "lutlib/color/gamut.h"
#include "lutlib/rgb.h"

#include <span>
#include <string_view>

namespace lutlib {

/// What curves without an end stop at: the largest half float.
inline constexpr double largest_light = 65504;
/// What an unbounded curve has as its darkest and brightest light.
inline constexpr double any_light = std::numeric_limits<double>::infinity();

/// Every row rises, strictly but where its light ends, and is finite for every float; Encoding
/// defines what NaN and infinities become.
struct TransferCurve {
    std::string_view name;
    std::string_view label;
    std::string_view source; ///< where the maker publishes the constants
    const Gamut* gamut;      ///< what the curve's name alone stands for
    /// Light beyond them is held to them, so a code that stands for more comes back as theirs.
    double darkest = -any_light, brightest = any_light;
    double (*decode)(double code);
    double (*encode)(double linear);
    /// The same of every channel of many colours, for the speed of one call; within 1e-12.
    void (*decode_all)(std::span<RgbD> colors);
    void (*encode_all)(std::span<RgbD> colors);
};

std::span<const TransferCurve* const> transfer_curves();
/// Null for an unknown name. Case and all but letters and digits do not count.
const TransferCurve* transfer_curve_named(std::string_view name);

/// A curve's function for many colours, from the one for a channel.
template <double (*one)(double)>
void each_channel(std::span<RgbD> colors) {
    for (RgbD& c : colors) {
        c = {one(c.r), one(c.g), one(c.b)};
    }
}

} // namespace lutlib
