// A look that stands before the tone map: the conversion of scene light to the codes that it takes,
// and of what it gives to light or to the picture; and those conversions as the shader reads them.
#pragma once

#include "lutlib/color/encoding.h"

#include <array>
#include <cstdint>
#include <vector>

namespace preview {

struct SceneLook {
    lutlib::Encoding fed;   ///< scene light is encoded so for it
    lutlib::Encoding gives; ///< what it gives is read so
    /// What it gives is the picture for the display, and no tone map follows; else it is light.
    bool is_picture = false;
    friend bool operator==(const SceneLook&, const SceneLook&) = default;
};

/// The bits by which shaders know the place of a look (common/scene_look.glsl).
struct PlaceBits {
    static constexpr std::uint32_t before = 1, encodes = 2, decodes = 4, is_picture = 8;
};
std::uint32_t place_bits(const SceneLook& look);

/// A curve in pieces of cubic polynomials, each through four of its values: what a shader reads in
/// place of the curve's formula. For every row of transfer_curves(), over light of 2^-24..65504:
/// within 1e-6 of a code, and 6e-5 where two parts of a curve meet or one ends; back within 1e-5 of
/// the light, and 1.2e-4 there.
///
/// Light: a piece for 0..2^lowest and 64 for each octave above, of either sign. Codes: even
/// pieces over a range that holds all codes of light up to 65504, or up to the code 4.
struct CubicCurve {
    using Piece = std::array<float, 4>; ///< c[0] + t (c[1] + t (c[2] + t c[3])), t over 0..1

    static constexpr int lowest = -24, octaves = 40, octave_pieces = 64;
    static constexpr int light_pieces = 1 + octaves * octave_pieces; ///< of one sign
    static constexpr int code_pieces = 1024;

    explicit CubicCurve(const lutlib::TransferCurve& curve);

    std::vector<Piece> encoding; ///< light of 0 and above, then of 0 and below
    std::vector<Piece> decoding;
    float low = 0, high = 1; ///< codes of the first and the last piece

    /// As the shader computes them; light beyond 65504 and codes beyond the range are held to
    /// those.
    float encode(float light) const;
    float decode(float code) const;
};

/// What a shader reads of one look, in rows of four floats: linear sRGB light to the look's light
/// (3 rows), the light that it gives to linear sRGB (3), the range of codes (1), the pieces of
/// fed's encoding and of gives' decoding.
std::vector<std::array<float, 4>> conversion_rows(const SceneLook& look);
inline constexpr std::size_t conversion_row_count =
    7 + 2 * CubicCurve::light_pieces + CubicCurve::code_pieces;

} // namespace preview
