// The characters that shaders/common/glyphs.glsl draws with dots.
#pragma once

#include <cstdint>

namespace preview {

/// The character's place there, letters as capitals; what is no letter or figure of ASCII and none
/// of . - _ + : is a question mark. One beyond all, `no_glyph`, for a space.
std::uint32_t glyph_of(char c);
inline constexpr std::uint32_t no_glyph = ~std::uint32_t{0};

} // namespace preview
