// The .3dl format of Autodesk's Flame and Lustre: a cube of integer codes.
//
//   file    = { line }
//   line    = blank | comment | keyword | mesh | row
//   comment = "#" text                    "Output bit depth" n and "Input bit depth" n in one
//   declare keyword = "3DMESH"                    Lustre
//           | "Mesh" a b                  Lustre: 2^a + 1 nodes per axis, codes of b bits
//           | "LUT8" | "gamma" number     Lustre's trailer
//           | other                       kept, not acted on
//   mesh    = number number number number { number }   the input codes of the nodes, of any depth
//   row     = number number number        whole numbers; blue fastest
//
// A depth that the file does not declare is guessed from the largest code as OpenColorIO does: up
// to 511 are 8 bits, to 2047 10, to 8191 12, beyond 16.
//
// Sources: Autodesk, "Lustre Color Management User Guide" (2009), and OpenColorIO's reader.
#pragma once

#include "lutlib/format.h"

#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// Parses a whole file. Notes say where the depth comes from. Throws Error naming `file`, the line
/// and its text.
Lut read_threedl(std::string_view bytes, const std::string& file);

inline constexpr int threedl_bits = 12;
/// A mesh line of less than four numbers would be taken for a row.
inline constexpr int min_threedl_size = 4;
/// OpenColorIO takes no more.
inline constexpr int max_threedl_size = 129;

/// Cubes of domain 0..1 within those sizes, clamped to 0..1. The mesh has even whole steps wherever
/// a depth has such, for the loader of three.js takes no other. Throws Error for anything else.
std::string write_flame(const Lut& lut, const WriteOptions& options);
std::string write_lustre(const Lut& lut, const WriteOptions& options);

/// Which programs do not read such a file, or read it otherwise: three.js for the mesh, ffmpeg
/// for a size other than 17 or Lustre's keywords, and all that guess the depth for a dark look. A
/// sentence each.
std::vector<std::string> flame_readers(const Lut& lut);
std::vector<std::string> lustre_readers(const Lut& lut);

} // namespace lutlib
