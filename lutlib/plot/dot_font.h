// Text of dots for pictures: the printable characters of ASCII, each 5 dots wide on a line of 9, of
// which the last two are for what hangs below it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace plot {

inline constexpr int glyph_width = 5, glyph_height = 9;
/// From a glyph to the next, and from a line to the next.
inline constexpr int glyph_step = 6, line_step = 11;
/// A box, drawn for every character that the font does not have.
inline constexpr char unknown_glyph = '\x7f';

/// Whether the glyph has a dot in column `x` of 0..4, row `y` of 0..8 from the top.
bool has_dot(char glyph, int x, int y);

/// One glyph a character: UTF-8 beyond ASCII, control characters and stray bytes become
/// unknown_glyph.
std::string glyphs_of(std::string_view utf8);

/// At most `most` glyphs: of a longer text the beginning and the end, with "..." between them.
std::string cut_in_the_middle(const std::string& glyphs, std::size_t most);
/// The same of UTF-8: as many characters as glyphs_of() makes glyphs of.
std::string text_cut_in_the_middle(const std::string& utf8, std::size_t most);

} // namespace plot
