// What is converted around a look where it stands, before the tone map or behind it, and those
// conversions as the shader reads them.
#pragma once

#include "lutlib/color/encoding.h"
#include "preview/look/cubic_curve.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace preview {

struct LookConversion {
    /// Behind the tone map: of the picture's codes, which the look gets; unset before it, where the
    /// look gets scene light.
    std::optional<lutlib::Encoding> codes;
    lutlib::Encoding fed;   ///< what the look gets is encoded so for it
    lutlib::Encoding gives; ///< what it gives is read so
    /// What it gives is the picture for the display, and no tone map follows; else it is light.
    bool is_picture = false;

    bool is_before() const { return !codes; }
    friend bool operator==(const LookConversion&, const LookConversion&) = default;
};

/// The bits by which shaders know the place of a look (common/look_conversion.glsl).
struct PlaceBits {
    static constexpr std::uint32_t before = 1, encodes = 2, decodes = 4, is_picture = 8, opens = 16;
};
/// 0 for one behind the tone map that needs no conversion.
std::uint32_t place_bits(const LookConversion& conversion);

/// What a shader reads of one look, in rows of four floats: linear sRGB light, or that of the
/// picture's codes, to the look's light (3 rows), the light that it gives to linear sRGB (3), the
/// ranges of codes of `gives` and of the picture (1), the pieces of fed's encoding, of gives'
/// decoding, and of that of the picture's codes (CubicCurve).
std::vector<std::array<float, 4>> conversion_rows(const LookConversion& conversion);
inline constexpr std::size_t conversion_row_count =
    7 + 2 * CubicCurve::light_pieces + 2 * CubicCurve::code_pieces;

} // namespace preview
