// Every size cap of the toolkit. All are checked before anything is allocated.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lutlib::limits {

inline constexpr int min_cube_size = 2;
inline constexpr int max_cube_size = 256;
inline constexpr int min_shaper_size = 2;
inline constexpr int max_shaper_size = 65536;

// A 256^3 table of long decimals is about 0.6 GiB.
inline constexpr std::size_t max_file_bytes = std::size_t{2} << 30;
inline constexpr std::size_t max_title_bytes = 4096;

// Side length of a picture that is read as a LUT or filtered through one.
inline constexpr int max_image_side = 65536;
inline constexpr std::size_t max_image_pixels = std::size_t{1} << 28;
// Of a picture that is read as a LUT: four lattices of the largest size.
inline constexpr std::size_t max_lut_picture_pixels = std::size_t{1} << 26;

// Of the grid over a cube's outputs by which it is inverted. Four bytes each, 256 MiB: 32 for each
// cell of the largest cube, where a smooth look needs 8. Noise would need more than 2^32 from 47^3
// on; it gets a coarser grid.
inline constexpr std::uint64_t max_output_index_entries = std::uint64_t{1} << 26;

} // namespace lutlib::limits
