// The inner loop of the .cube reader: rows of three plain decimals, eight digits at a time.
#pragma once

#include "lutlib/rgb.h"

#include <cstddef>
#include <string_view>

namespace lutlib {

/// What parse_rows took from the front of a text.
struct RowRun {
    std::size_t rows = 0;
    std::size_t bytes = 0;
};

/// How many bytes before a text's end parse_rows() stops at the latest.
inline constexpr std::size_t rows_look_ahead = 128;

/// Reads rows of three numbers, single blanks or tabs between them and LF or CR LF behind, for as
/// long as they have that form, `most` at the most, each correctly rounded: fast those of the form
/// [-]digits[.digits], others, with an exponent for one, through std::from_chars. Stops before the
/// first row that has not (and rows_look_ahead before the text's end): the caller's general reader
/// takes that line.
RowRun parse_rows(std::string_view text, Rgb* out, std::size_t most);

} // namespace lutlib
