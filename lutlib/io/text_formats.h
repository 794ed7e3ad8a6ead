// Writers of the text formats that OpenColorIO reads but does not write, or not exactly. All write
// the shortest decimals that read back bit-identically.
//
//   spi1d   "Version 1" / "From" min max / "Length" n / "Components 3" / "{" / n rows r g b / "}"
//   spi3d   "SPILUT 1.0" / "3 3" / N N N / N^3 rows: ir ig ib r g b
//   csp     "CSPLUTV100" / "1D" or "3D" / "BEGIN METADATA" .. "END METADATA" / three preluts, each:
//           n / n inputs / n outputs / then either n and n rows r g b, or N N N and N^3 rows, red
//           fastest. A prelut is piecewise and takes the look's domain, or its shaper, to 0..1.
//
// Sources: Sony Pictures Imageworks' formats as read by OpenColorIO; Rising Sun Research,
// "cineSpace LUT file format" (2008).
#pragma once

#include "lutlib/format.h"

#include <string>

namespace lutlib::io {

/// A curve whose channels have one domain. Throws Error for anything else.
std::string write_spi1d(const Lut& lut, const WriteOptions& options);
/// A cube of domain 0..1. Throws Error for anything else.
std::string write_spi3d(const Lut& lut, const WriteOptions& options);
/// Any look.
std::string write_csp(const Lut& lut, const WriteOptions& options);

} // namespace lutlib::io
