// The pixels of a PNG on their way into the file: rows filtered (PNG 3rd edition, 9) and compressed
// (RFC 1950, 1951) in blocks that need nothing of each other, on every core.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lutlib::io {

/// Rows from the top without gaps, samples in the machine's byte order.
struct PngRows {
    const std::byte* samples = nullptr;
    std::size_t bytes_a_row = 0, rows = 0;
    std::size_t bytes_a_pixel = 3; ///< 3, 4, 6 or 8
    bool is_16_bit = false;
};

/// The IDAT chunks of the rows, which are the same on any number of cores. Every few rows get the
/// filter by whose result one of them is smallest, taken as signed bytes.
std::string packed_rows(const PngRows& rows);

enum class RowFilter : std::uint8_t { none, sub, up, average, paeth };

/// One row, as the file has its bytes, into as many; `above` is the row above it, of zeros for the
/// first.
void filter_row(RowFilter filter, std::span<const std::uint8_t> row,
                std::span<const std::uint8_t> above, std::size_t bytes_a_pixel,
                std::span<std::uint8_t> out);

/// The Adler-32 of two pieces one after the other, by those of each and the second one's length.
std::uint32_t joined_adler(std::uint32_t first, std::uint32_t second, std::size_t second_length);

} // namespace lutlib::io
