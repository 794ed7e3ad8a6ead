// What the code values of a picture or a LUT mean: a transfer curve and a set of primaries.
#pragma once

#include "lutlib/color/primaries.h"

#include <span>
#include <string_view>

namespace lutlib {

struct Encoding {
    std::string_view name;
    std::string_view label;
    std::string_view source;
    Primaries primaries;
    double (*decode)(double code);
    double (*encode)(double linear);
    /// The same of every channel of many colours, for the speed of one call.
    void (*decode_all)(std::span<RgbD> colours);
    void (*encode_all)(std::span<RgbD> colours);
};

/// srgb, gamma24, linear, logc3, acescct, pq. Linear light of 1 is diffuse white, 100 cd/m2 in PQ.
std::span<const Encoding> encodings();
const Encoding* encoding_named(std::string_view name);

/// The first row.
const Encoding& srgb();

} // namespace lutlib
