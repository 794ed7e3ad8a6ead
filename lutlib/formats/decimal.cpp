#include "lutlib/formats/decimal.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace lutlib {
namespace {

static_assert(std::endian::native == std::endian::little, "the digit loads assume little endian");

// More bytes than a row is looked at ahead: three numbers of a sign, at most 15 digits and a point,
// their separators, and the last eight-byte load.
constexpr std::size_t look_ahead = 128;

constexpr std::array<double, 17> power_of_ten{1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                                              1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};

std::uint64_t load(const char* p) {
    std::uint64_t bytes;
    std::memcpy(&bytes, p, sizeof bytes);
    return bytes;
}

// How many of the eight characters are digits before the first that is none.
unsigned leading_digits(std::uint64_t bytes) {
    // A byte is a digit when neither byte + 0x46 (above '9') nor byte - 0x30 (below '0') sets its
    // top bit. A borrow or carry only ever runs into bytes behind the first that is no digit.
    const std::uint64_t other =
        ((bytes + 0x4646464646464646U) | (bytes - 0x3030303030303030U)) & 0x8080808080808080U;
    return static_cast<unsigned>(std::countr_zero(other)) / 8;
}

// The value of the first `count` (1..8) digits of the eight characters. Pairs, then fours, then
// all eight are joined by one multiplication each (Lemire and Langdale's integer parsing).
std::uint64_t digits_value(std::uint64_t bytes, unsigned count) {
    std::uint64_t v = (bytes - 0x3030303030303030U) << (8 * (8 - count));
    v = v * 10 + (v >> 8);
    constexpr std::uint64_t mask = 0x000000FF000000FFU;
    return (((v & mask) * 0x000F424000000064U) + (((v >> 16) & mask) * 0x0000271000000001U)) >> 32;
}

// mantissa / 10^decimals, correctly rounded, or false when double rounding might spoil it.
bool round_to_float(std::uint64_t mantissa, unsigned decimals, float& out) {
    if (mantissa < (std::uint64_t{1} << 24) && decimals <= 10) {
        // Both operands are exact floats, so one division rounds once (Clinger 1990).
        out = static_cast<float>(mantissa) / static_cast<float>(power_of_ten[decimals]);
        return true;
    }
    const double wide = static_cast<double>(mantissa) / power_of_ten[decimals];
    // The double is correctly rounded and the midpoints of floats are doubles: rounding twice goes
    // wrong only from exactly such a midpoint.
    constexpr std::uint64_t below_float = (std::uint64_t{1} << 29) - 1;
    if ((std::bit_cast<std::uint64_t>(wide) & below_float) == (std::uint64_t{1} << 28)) {
        return false;
    }
    out = static_cast<float>(wide);
    return true;
}

// One number at p; the character behind it, or null when it has not the plain form.
const char* parse_number(const char* p, float& out) {
    const bool negative = *p == '-';
    p += negative;
    std::uint64_t bytes = load(p);
    unsigned whole = leading_digits(bytes);
    if (whole == 0 || whole == 8) {
        return nullptr;
    }
    std::uint64_t mantissa = whole == 1 ? (bytes & 0xF) : digits_value(bytes, whole);
    unsigned decimals = 0;
    p += whole;
    if (*p == '.') {
        ++p;
        bytes = load(p);
        unsigned count = leading_digits(bytes);
        while (count > 0) {
            decimals += count;
            if (whole + decimals > 15) {
                return nullptr;
            }
            mantissa = mantissa * static_cast<std::uint64_t>(power_of_ten[count]) +
                       digits_value(bytes, count);
            p += count;
            if (count < 8) {
                break;
            }
            bytes = load(p);
            count = leading_digits(bytes);
        }
    }
    if (!round_to_float(mantissa, decimals, out)) {
        return nullptr;
    }
    out = negative ? -out : out;
    return p;
}

bool blank(char c) {
    return c == ' ' || c == '\t';
}

} // namespace

RowRun parse_rows(std::string_view text, Rgb* out, std::size_t most) {
    RowRun run;
    if (text.size() < look_ahead) {
        return run;
    }
    const char* const last = text.data() + text.size() - look_ahead;
    const char* p = text.data();
    while (run.rows < most && p < last) {
        Rgb row;
        const char* q = parse_number(p, row.r);
        if (!q || !blank(*q)) {
            break;
        }
        q = parse_number(q + 1, row.g);
        if (!q || !blank(*q)) {
            break;
        }
        q = parse_number(q + 1, row.b);
        if (!q) {
            break;
        }
        q += *q == '\r' && q[1] == '\n';
        if (*q != '\n') {
            break;
        }
        out[run.rows++] = row;
        p = q + 1;
    }
    run.bytes = static_cast<std::size_t>(p - text.data());
    return run;
}

} // namespace lutlib
