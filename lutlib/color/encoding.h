// What the code values of a picture or a LUT mean: a transfer curve and a set of primaries.
#pragma once

#include "lutlib/color/gamut.h"
#include "lutlib/color/transfer_curve.h"
#include "lutlib/lut.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lutlib {

/// As every conversion reads a number: NaN as 0, the rest within the range of a float.
inline double held(double x) {
    constexpr double limit = std::numeric_limits<float>::max();
    return x >= -limit ? std::min(x, limit) : x < 0 ? -limit : 0;
}

struct Encoding {
    const TransferCurve* curve = nullptr; ///< never null but in a default-constructed one
    const Gamut* gamut = nullptr;

    /// "slog3" for a curve with its own gamut, "slog3/rec709" for another.
    std::string name() const;
    std::string label() const;
    const Primaries& primaries() const { return gamut->primaries; }

    double decode(double code) const { return curve->decode(held(code)); }
    double encode(double linear) const { return curve->encode(held(linear)); }
    void decode_all(std::span<RgbD> colors) const;
    void encode_all(std::span<RgbD> colors) const;

    friend bool operator==(const Encoding&, const Encoding&) = default;
};

/// What a look takes and what it gives, as far as that is known.
struct LookEncodings {
    std::optional<Encoding> input, output;

    friend bool operator==(const LookEncodings&, const LookEncodings&) = default;
};

/// As a Lut keeps them, which is as files do.
EncodingNames names_of(const LookEncodings& encodings);
/// Those of the names that encoding_named() knows.
LookEncodings encodings_of(const EncodingNames& names);

/// Every curve with its own gamut; sRGB first.
std::span<const Encoding> encodings();

/// "curve" or "curve/gamut", such as "slog3/sgamut3.cine", also with a blank between ("S-Log3
/// S-Gamut3.Cine"). Null for an unknown name.
std::optional<Encoding> encoding_named(std::string_view name);
/// The same. Throws UsageError with the names there are.
Encoding require_encoding(std::string_view name);

const Encoding& srgb();

/// Light of one encoding to light of another.
Matrix3 light_to_light(const Encoding& from, const Encoding& to, const Adaptation& how = bradford);

} // namespace lutlib
