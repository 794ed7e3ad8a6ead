#include "lutlib/io/png_rows.h"

#include "lutlib/error.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <memory>
#include <vector>

namespace lutlib::io {
namespace {

using Byte = std::uint8_t;

constexpr std::array<RowFilter, 5> filters{RowFilter::none, RowFilter::sub, RowFilter::up,
                                           RowFilter::average, RowFilter::paeth};
// Rows that share a filter, and bytes that are compressed without what stands before them: where a
// block begins, its first 32 KB find fewer repeats, a hundredth of the size of photographs.
constexpr std::size_t rows_a_choice = 8, bytes_a_block = std::size_t{1} << 19;

Byte paeth(Byte left, Byte above, Byte corner) {
    const int to_left = std::abs(above - corner), to_above = std::abs(left - corner),
              to_corner = std::abs(left + above - 2 * corner);
    return to_left <= to_above && to_left <= to_corner ? left
           : to_above <= to_corner                     ? above
                                                       : corner;
}

std::uint64_t sum_as_signed(std::span<const Byte> bytes) {
    std::uint64_t sum = 0;
    for (const Byte byte : bytes) {
        sum += static_cast<std::uint64_t>(byte < 128 ? byte : 256 - byte);
    }
    return sum;
}

void append_number(std::string& out, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        out += static_cast<char>(number >> shift & 0xff);
    }
}

// A chunk whose data stand in `out` from `data` on, behind 8 bytes that are left for its head.
void finish_chunk(std::string& out, std::size_t head) {
    const std::size_t length = out.size() - head - 8;
    std::string text;
    append_number(text, static_cast<std::uint32_t>(length));
    text += "IDAT";
    std::copy(text.begin(), text.end(), out.begin() + static_cast<std::ptrdiff_t>(head));
    append_number(
        out, crc32_gzip_refl(0, reinterpret_cast<const Byte*>(out.data() + head + 4), length + 4));
}

// What a thread needs, kept from block to block.
class Packer {
  public:
    explicit Packer(const PngRows& rows)
        : rows_(rows), row_(rows.bytes_a_row), above_(rows.bytes_a_row), trial_(rows.bytes_a_row),
          level_buffer_(ISAL_DEF_LVL1_DEFAULT) {}

    struct Block {
        std::string chunk;
        std::uint32_t adler = 1;
        std::size_t bytes = 0; ///< before compression
    };

    // Rows [first, last).
    Block pack(std::size_t first, std::size_t last) {
        filter(first, last);
        Block out;
        out.bytes = filtered_.size();
        out.adler = isal_adler32(1, filtered_.data(), filtered_.size());
        constexpr std::size_t head = 8;
        out.chunk.assign(head, '\0');
        if (first == 0) {
            out.chunk += "\x78\x01"; // a window of 32 KB, the fastest level (RFC 1950, 2.2)
        }
        deflate(out.chunk, last == rows_.rows);
        finish_chunk(out.chunk, 0);
        return out;
    }

  private:
    void filter(std::size_t first, std::size_t last) {
        const std::size_t length = rows_.bytes_a_row + 1;
        filtered_.resize((last - first) * length);
        if (first == 0) {
            std::fill(above_.begin(), above_.end(), Byte{0});
        } else {
            load(first - 1, above_);
        }
        RowFilter chosen{};
        for (std::size_t y = first; y < last; ++y) {
            load(y, row_);
            if (y == first || y % rows_a_choice == 0) {
                chosen = choose();
            }
            Byte* const to = filtered_.data() + (y - first) * length;
            *to = static_cast<Byte>(chosen);
            filter_row(chosen, row_, above_, rows_.bytes_a_pixel, {to + 1, rows_.bytes_a_row});
            row_.swap(above_);
        }
    }

    void load(std::size_t y, std::vector<Byte>& row) const {
        const std::byte* const from = rows_.samples + y * rows_.bytes_a_row;
        std::memcpy(row.data(), from, row.size());
        for (std::size_t i = 0; rows_.is_16_bit && i + 1 < row.size(); i += 2) {
            std::uint16_t code = 0;
            std::memcpy(&code, from + i, sizeof code);
            row[i] = static_cast<Byte>(code >> 8);
            row[i + 1] = static_cast<Byte>(code & 0xff);
        }
    }

    RowFilter choose() {
        RowFilter best = filters[0];
        std::uint64_t least = ~std::uint64_t{0};
        for (const RowFilter filter : filters) {
            filter_row(filter, row_, above_, rows_.bytes_a_pixel, trial_);
            const std::uint64_t sum = sum_as_signed(trial_);
            if (sum < least) {
                least = sum;
                best = filter;
            }
        }
        return best;
    }

    // A block that is not the last ends as RFC 1951's stored block without bytes, on a whole byte.
    void deflate(std::string& out, bool is_last) {
        isal_zstream stream;
        isal_deflate_init(&stream);
        stream.level = 1;
        stream.level_buf = level_buffer_.data();
        stream.level_buf_size = static_cast<std::uint32_t>(level_buffer_.size());
        stream.flush = FULL_FLUSH;
        stream.end_of_stream = is_last ? 1 : 0;
        stream.next_in = filtered_.data();
        stream.avail_in = static_cast<std::uint32_t>(filtered_.size());
        const std::size_t start = out.size();
        std::size_t length = 0;
        do {
            // Nothing that it makes of incompressible bytes is longer than stored blocks of them.
            out.resize(start + length + filtered_.size() + filtered_.size() / 64 + 1024);
            stream.next_out = reinterpret_cast<Byte*>(out.data()) + start + length;
            stream.avail_out = static_cast<std::uint32_t>(out.size() - start - length);
            const std::uint32_t before = stream.avail_out;
            if (isal_deflate(&stream) != COMP_OK) {
                throw Error("cannot compress the PNG file");
            }
            length += before - stream.avail_out;
        } while (stream.avail_out == 0);
        out.resize(start + length);
    }

    const PngRows& rows_;
    std::vector<Byte> row_, above_, trial_, level_buffer_, filtered_;
};

} // namespace

void filter_row(RowFilter filter, std::span<const Byte> row, std::span<const Byte> above,
                std::size_t bytes_a_pixel, std::span<Byte> out) {
    const Byte* const r = row.data();
    const Byte* const u = above.data();
    Byte* __restrict const o = out.data();
    const std::size_t n = row.size(), first = std::min(bytes_a_pixel, n), d = bytes_a_pixel;
    switch (filter) {
    case RowFilter::none:
        std::copy(row.begin(), row.end(), out.begin());
        break;
    case RowFilter::sub:
        std::copy_n(r, first, o);
        for (std::size_t i = first; i < n; ++i) {
            o[i] = static_cast<Byte>(r[i] - r[i - d]);
        }
        break;
    case RowFilter::up:
        for (std::size_t i = 0; i < n; ++i) {
            o[i] = static_cast<Byte>(r[i] - u[i]);
        }
        break;
    case RowFilter::average:
        for (std::size_t i = 0; i < first; ++i) {
            o[i] = static_cast<Byte>(r[i] - u[i] / 2);
        }
        for (std::size_t i = first; i < n; ++i) {
            o[i] = static_cast<Byte>(r[i] - (r[i - d] + u[i]) / 2);
        }
        break;
    case RowFilter::paeth:
        for (std::size_t i = 0; i < first; ++i) {
            o[i] = static_cast<Byte>(r[i] - u[i]);
        }
        for (std::size_t i = first; i < n; ++i) {
            o[i] = static_cast<Byte>(r[i] - paeth(r[i - d], u[i], u[i - d]));
        }
        break;
    }
}

std::uint32_t joined_adler(std::uint32_t first, std::uint32_t second, std::size_t second_length) {
    // a = 1 + sum of bytes, b = sum of all a (RFC 1950, 8.2): the second's a begins at the first's,
    // not at 1, in each of its steps.
    constexpr std::uint64_t modulus = 65521;
    const std::uint64_t a1 = first & 0xffff, b1 = first >> 16, a2 = second & 0xffff,
                        b2 = second >> 16, length = second_length % modulus;
    const std::uint64_t a = (a1 + a2 + modulus - 1) % modulus;
    const std::uint64_t b = (b1 + b2 + length * ((a1 + modulus - 1) % modulus)) % modulus;
    return static_cast<std::uint32_t>(b << 16 | a);
}

std::string packed_rows(const PngRows& rows) {
    const std::size_t rows_a_block =
        std::max<std::size_t>(1, bytes_a_block / (rows.bytes_a_row + 1));
    const std::size_t count = (rows.rows + rows_a_block - 1) / rows_a_block;
    std::vector<Packer::Block> blocks(count);
    tbb::enumerable_thread_specific<std::unique_ptr<Packer>> packers;
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        std::unique_ptr<Packer>& packer = packers.local();
        if (!packer) {
            packer = std::make_unique<Packer>(rows);
        }
        blocks[i] = packer->pack(i * rows_a_block, std::min(rows.rows, (i + 1) * rows_a_block));
    });
    std::size_t length = 0;
    std::uint32_t adler = 1;
    for (const Packer::Block& block : blocks) {
        length += block.chunk.size();
        adler = joined_adler(adler, block.adler, block.bytes);
    }
    constexpr std::size_t frame = 12;
    std::string out;
    out.reserve(length + frame + sizeof adler);
    for (Packer::Block& block : blocks) {
        out += block.chunk;
        block.chunk = {};
    }
    const std::size_t head = out.size();
    out.append(8, '\0');
    append_number(out, adler);
    finish_chunk(out, head);
    return out;
}

} // namespace lutlib::io
