// The .cube format, both dialects.
//
//   file    = [BOM] { line end }               the last end may be missing
//   end     = LF | CR LF | CR
//   line    = blank | comment | keyword | row    a comment may follow any but a TITLE
//   comment = "#" text
//   keyword = "TITLE" text                       quoted or not
//           | "LUT_1D_SIZE" n                    2 .. 65536
//           | "LUT_3D_SIZE" n                    2 .. 256
//           | "DOMAIN_MIN" r g b                 Adobe/Iridas: the input of the first entry
//           | "DOMAIN_MAX" r g b                 and of the last, per channel
//           | "LUT_1D_INPUT_RANGE" min max       Resolve: the same, of the 1D table
//           | "LUT_3D_INPUT_RANGE" min max       Resolve: of the 3D table
//           | other [text]                       kept, written back and not acted on
//   row     = number number number               blanks between; a decimal comma is read
//
// Two comments say what the code values are, before the look and after it (encoding_comment.h):
//
//   # Input encoding: slog3/sgamut3.cine
//   # Output encoding: gamma24/rec709
//
// Keywords are read in any case. They may stand anywhere, but sizes before the first row, and
// unknown ones not among the rows, where they are taken for damaged rows. The rows are the 1D
// table's, if there is one, then the 3D table's, red fastest. With both tables the 1D table shapes
// the input of the 3D table, and DOMAIN_MIN/MAX belong to the 1D table. Text is UTF-8, or UTF-16,
// told by its first bytes. Tables of whole numbers are codes (integer_codes.h).
//
// Sources: Adobe, "Cube LUT Specification 1.0" (2013); Blackmagic Design, DaVinci Resolve's
// "LUT files" readme.
#pragma once

#include "lutlib/byte_source.h"
#include "lutlib/format.h"

#include <string>
#include <string_view>

namespace lutlib {

enum class CubeDialect { adobe, resolve };

/// Parses a whole file. Throws Error naming `file`, the line and its text: for a table that is
/// missing, truncated, overlong or out of limits.h, a value that is not a finite number, a row with
/// commas and points, a domain that is empty, inverted or said twice, a binary or empty file.
Lut read_cube(std::string_view bytes, const std::string& file);
/// The same of UTF-8 text that begins with `head`, 4096 bytes at least unless it is shorter, and
/// goes on with what `more` gives.
Lut read_cube_in_pieces(std::string_view head, ByteSource& more, const std::string& file);
/// As read_cube(), but a row's values that are infinite or no number are read as NaN: for examining
/// and repairing. What it returns may fail validate().
Lut read_broken_cube(std::string_view bytes, const std::string& file);

/// Whether a row of the text has them; other readers stop there.
bool has_decimal_commas(std::string_view text);

/// The shortest decimals that read back bit-identically. Throws Error for what the dialect cannot
/// say (the `holds` of its row): fit the Lut first.
std::string write_cube(const Lut& lut, CubeDialect dialect, const WriteOptions& options = {});

/// The dialect that keeps most of this look: Resolve for a shaper before a cube, else Adobe.
CubeDialect best_dialect(const Lut& lut);

} // namespace lutlib
