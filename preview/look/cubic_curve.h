// A transfer curve as shaders read it: in pieces of cubic polynomials.
#pragma once

#include "lutlib/color/transfer_curve.h"

#include <array>
#include <vector>

namespace preview {

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

} // namespace preview
